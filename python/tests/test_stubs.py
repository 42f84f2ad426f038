"""The stubs name what the extension module has, and everything public has a docstring."""
import ast
import inspect
import unittest
from pathlib import Path

import waymark as wm
from waymark import _waymark

STUBS = ast.parse((Path(wm.__file__).parent / "_waymark.pyi").read_text())


def public(names):
    return {name for name in names if not name.startswith("_") or name in ("_repr_svg_", "_repr_latex_")}


class Stubs(unittest.TestCase):
    def test_the_module_and_its_stub_have_the_same_names(self):
        stub = {node.name for node in STUBS.body if isinstance(node, (ast.ClassDef, ast.FunctionDef))}
        self.assertEqual(stub, {name for name in public(vars(_waymark)) if name != "version"})

    def test_every_class_and_its_stub_have_the_same_members(self):
        for node in STUBS.body:
            if not isinstance(node, ast.ClassDef) or issubclass(getattr(_waymark, node.name), Exception):
                continue
            stub = {item.name for item in node.body if isinstance(item, ast.FunctionDef)}
            stub |= {item.target.id for item in node.body if isinstance(item, ast.AnnAssign)}
            self.assertEqual(public(stub), public(vars(getattr(_waymark, node.name))), node.name)

    def test_everything_public_has_a_docstring(self):
        for name in wm.__all__:
            thing = getattr(wm, name)
            self.assertTrue(inspect.getdoc(thing), name)
            if inspect.isclass(thing):
                for member, value in vars(thing).items():
                    if not member.startswith("_") and (callable(value) or isinstance(value, property)):
                        self.assertTrue(inspect.getdoc(value), f"{name}.{member}")


if __name__ == "__main__":
    unittest.main()

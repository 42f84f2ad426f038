// waymark._waymark: the libraries as Python classes. The package waymark around it is what people import.
#include "libltl/diagnostic.hpp"
#include "python/handles.hpp"

namespace waymark::python {
namespace {

// Our errors as Python's: the type, a subclass of one that Python has, and the message. SyntaxError of ours also tells
// where: `line` and `column`, counted from 1.
void register_errors(py::module_& m) {
  static py::handle parse_error, format_error, limit_error;
  const auto type = [&](const char* name, const char* doc, PyObject* parent) {
    PyObject* made = PyErr_NewExceptionWithDoc((std::string("waymark.") + name).c_str(), doc, parent, nullptr);
    if (made == nullptr) throw py::error_already_set();
    m.add_object(name, made);
    return py::handle(made);
  };
  parse_error =
      type("ParseError", "A formula or a word that cannot be read; has `line` and `column`.", PyExc_ValueError);
  format_error = type("FormatError", "A file, a map, a pose or a proposition that does not fit.", PyExc_ValueError);
  limit_error = type("LimitError", "A limit was met; nothing is proved.", PyExc_RuntimeError);
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const ltl::SyntaxError& error) {
      const py::object made = py::reinterpret_borrow<py::object>(parse_error)(error.what());
      made.attr("line") = error.line();
      made.attr("column") = error.column();
      PyErr_SetObject(parse_error.ptr(), made.ptr());
    } catch (const ltl::FormatError& error) {
      PyErr_SetString(format_error.ptr(), error.what());
    } catch (const LimitMet& error) {
      PyErr_SetString(limit_error.ptr(), error.what());
    }
  });
}

}  // namespace
}  // namespace waymark::python

PYBIND11_MODULE(_waymark, m) {
  using namespace waymark::python;
  m.doc() = "The libraries of waymark; import the package waymark instead.";
  m.attr("version") = WAYMARK_VERSION;
  register_errors(m);
  bind_maps(m);  // formulas speak of maps
  bind_formulas(m);
  bind_automata(m);
  bind_reading(m);
  bind_environment(m);
}

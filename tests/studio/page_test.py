"""The page of the studio in a real browser: what is typed, clicked and pressed, and what is seen then.

page_test.py WAYMARK FOLDER: the executable, and where screenshots are put. Exit code 77: something is not installed.
"""
import json
import os
import subprocess
import sys
import tempfile
import unittest

try:
    import websocket  # noqa: F401
except ImportError:
    print('SKIPPED: the studio is not tested in a browser: python3-websocket is not installed')
    sys.exit(77)
import browser as chromium

WAYMARK, FOLDER = sys.argv[1:3]
DEMO = 'walk past the lamp to the easel. take a left. go forward until you reach the blue hall.'
IDLE = '!document.body.dataset.busy'


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.server = subprocess.Popen([WAYMARK, 'serve', '--port', '0'], stdout=subprocess.PIPE, text=True)
        cls.address = cls.server.stdout.readline().split()[-1]
        cls.browser = chromium.Browser()

    @classmethod
    def tearDownClass(cls):
        cls.browser.close()
        cls.server.terminate()
        cls.server.wait(10)
        cls.server.stdout.close()

    def setUp(self):
        self.browser.problems.clear()
        self.browser.size(1280, 900)
        self.browser.scheme('light')

    def tearDown(self):
        self.assertEqual(self.browser.problems, [])

    def open(self, fragment='map=grid&start=1,9,0'):
        self.browser.open(f'{self.address}#{fragment}')

    def say(self, text):
        self.browser.clear('#instruction')
        self.browser.type(text)
        self.browser.press('Enter')
        self.browser.wait(IDLE)

    def formula(self, text):
        self.browser.clear('#formula')
        self.browser.type(text)

    def choose(self, selector, value):
        place = f'document.querySelector({json.dumps(selector)})'
        self.browser.evaluate(f'{place}.value = {json.dumps(value)};'
                              f' {place}.dispatchEvent(new Event("change", {{bubbles: true}}))')

    def wait_for_text(self, selector, part):
        self.browser.wait(f'document.querySelector({json.dumps(selector)}).textContent.includes({json.dumps(part)})'
                          f' && {IDLE}')

    def picture(self, name):
        self.browser.evaluate('scrollTo(0, 0)')
        self.browser.wait("document.getAnimations().every((animation) => animation.playState === 'finished')")
        path = os.path.join(FOLDER, f'{name}.png')
        self.browser.screenshot(path)
        self.assertGreater(os.path.getsize(path), 20_000)

    def pose(self):
        return self.browser.evaluate("document.querySelector('#agent').dataset.pose")

    def test_an_instruction_gives_readings_a_formula_a_route_and_an_automaton(self):
        self.open()
        self.say(DEMO)
        self.assertIn('go to the easel', self.browser.text('#understood'))
        self.assertIn('◇(easel', self.browser.text('#notation'))
        self.assertIn('5 actions, certified by the definition', self.browser.text('#answer'))
        self.assertIn('4 states, 9 edges', self.browser.text('#size'))
        self.assertGreater(self.browser.evaluate("document.querySelectorAll('.reading').length"), 1)
        self.assertEqual(self.browser.evaluate("document.querySelectorAll('#graph .node ellipse').length"), 5)
        self.assertIn('dotted blue route', self.browser.text('#question'))
        self.assertEqual(self.browser.evaluate("document.querySelectorAll('.route.other').length"), 1)

    def test_words_show_what_they_name_and_what_a_symbol_attended_to(self):
        self.open()
        self.say(DEMO)
        self.browser.wait("!document.querySelector('#origin').hidden")
        named = self.browser.evaluate("[...document.querySelectorAll('.named')].map((word) => word.textContent)")
        self.assertEqual(named, ['lamp', 'easel', 'blue'])
        self.browser.evaluate(
            "[...document.querySelectorAll('.symbol')].find((symbol) => symbol.textContent === 'left').focus()")
        weights = self.browser.evaluate(
            "[...document.querySelectorAll('.word')].map(word => Number(word.style.getPropertyValue('--weight')))")
        word = weights.index(max(weights))
        self.assertEqual(self.browser.evaluate(f"document.querySelectorAll('.word')[{word}].textContent"), 'left')
        self.assertGreater(max(weights), 0.5)

    def test_steps_move_the_agent_light_the_state_and_show_what_remains(self):
        self.open()
        self.say(DEMO)
        self.assertEqual(self.pose(), '1,9,0')
        for _ in range(3):
            self.browser.click('#next')
        self.assertEqual(self.pose(), '1,6,0')
        self.assertEqual(self.browser.text('#graph .node.lit title'), '1')
        self.assertIn('behind_lamp', self.browser.text('#letter'))
        self.assertIn('turned_left', self.browser.text('#remains'))
        self.picture('studio')
        self.browser.click('#back')
        self.assertEqual(self.pose(), '1,7,0')
        self.browser.click('#play')
        self.browser.wait("document.querySelector('#agent').dataset.pose === '0,6,270'")
        self.wait_for_text('#verdict', 'satisfied')
        self.browser.wait("document.querySelector('#play').textContent === 'Play'")

    def test_a_formula_that_is_edited_is_planned_again(self):
        self.open()
        self.formula('F(chair & X F lamp)')
        self.wait_for_text('#answer', 'certified')
        self.assertIn('◇(chair ∧ ○◇lamp)', self.browser.text('#notation'))
        before = self.browser.text('#answer')
        self.formula('F hatrack & G !lamp')
        self.wait_for_text('#notation', '◇hatrack')
        self.wait_for_text('#answer', 'certified')
        self.assertNotEqual(self.browser.text('#answer'), before)

    def test_an_error_stands_under_the_place_where_the_formula_is_wrong(self):
        self.open()
        self.formula('F sofa & F sofaa')
        self.browser.wait("!document.querySelector('#fault').hidden")
        fault = self.browser.text('#fault').split('\n')
        self.assertEqual(fault[0][1:], 'F sofa & F sofaa')
        self.assertEqual(fault[1].index('^') - 1, len('F sofa & F '))
        self.assertIn("did you mean 'sofa'", fault[2])
        self.browser.press('Backspace')
        self.browser.wait("document.querySelector('#fault').hidden")
        self.wait_for_text('#answer', 'certified')

    def test_what_is_not_understood_says_so(self):
        self.open()
        self.say('purple monkey dishwasher')
        self.wait_for_text('#message', 'I did not understand this.')
        self.assertIn('“monkey”', self.browser.text('#message'))

    def test_a_newcomer_clicks_an_example(self):
        self.open()
        self.assertFalse(self.browser.evaluate("document.querySelector('#welcome').hidden"))
        self.assertEqual(self.browser.evaluate("document.querySelectorAll('#examples button').length"), 3)
        self.browser.click('#examples button')
        self.wait_for_text('#answer', 'certified')
        self.assertTrue(self.browser.evaluate("document.querySelector('#welcome').hidden"))
        kinds = self.browser.evaluate("[...document.querySelectorAll('#legend span')].filter((key) => !key.hidden)"
                                      '.map((key) => key.dataset.kind)')
        self.assertEqual([kind for kind in kinds if kind != 'other'], ['ahead', 'first'])

    def nothing_is_left(self):
        for part in ('#understood', '#answer', '#notation'):
            self.assertEqual(self.browser.text(part), '', part)
        self.assertTrue(self.browser.evaluate("document.querySelector('#automaton').hidden"))
        self.assertEqual(self.browser.evaluate("document.querySelectorAll('.route').length"), 0)

    def test_what_is_refused_or_emptied_leaves_no_older_answer(self):
        self.open()
        self.say(DEMO)
        self.assertEqual(self.browser.evaluate("document.querySelectorAll('.route.other').length"), 1)
        self.say('purple monkey dishwasher')
        self.nothing_is_left()
        self.say('')
        self.assertEqual(self.browser.text('#message'), '')
        self.say(DEMO)
        self.formula('')
        self.browser.press('Backspace')
        self.browser.wait("document.querySelector('#automaton').hidden")
        self.nothing_is_left()

    def test_words_that_no_part_of_the_formula_may_come_from_are_marked(self):
        self.open()
        self.say(DEMO)
        self.browser.wait("!document.querySelector('#origin').hidden")
        unread = self.browser.evaluate("[...document.querySelectorAll('.unread')].map((word) => word.textContent)")
        for named in ('lamp', 'easel', 'blue', 'left.'):
            self.assertNotIn(named, unread)

    def test_a_task_without_route_says_why(self):
        self.open()
        self.formula('F sofa & G !sofa')
        self.wait_for_text('#answer', 'No route')

    def test_a_file_that_is_no_map_is_refused_and_a_map_is_shown(self):
        self.open()
        with tempfile.TemporaryDirectory() as folder:
            bad, good = os.path.join(folder, 'bad.json'), os.path.join(folder, 'good.json')
            with open(bad, 'w') as file:
                file.write('<html>no map</html>')
            with open(good, 'w') as file:
                json.dump({'name': 'yard', 'objects': ['lamp'], 'floors': ['grass'], 'walls': [],
                           'nodes': [{'x': 0, 'y': 0}, {'x': 1, 'y': 0, 'object': 'lamp'}],
                           'edges': [{'a': [0, 0], 'b': [1, 0], 'floor': 'grass'}]}, file)
            self.browser.give_file('#file', bad)
            self.wait_for_text('#message', 'the file')
            self.assertEqual(self.browser.evaluate("document.querySelector('#message').className"), 'bad')
            self.assertEqual(self.browser.evaluate("document.querySelector('#map').value"), 'grid')
            self.browser.give_file('#file', good)
            self.wait_for_text('#message', 'yard')
        self.assertEqual(self.browser.evaluate("document.querySelectorAll('#paper circle.node').length"), 2)
        self.formula('F lamp')
        self.wait_for_text('#answer', 'certified')

    def test_a_trajectory_drawn_by_hand_is_judged(self):
        self.open()
        self.formula('F easel & G !lamp')
        self.wait_for_text('#answer', 'certified')
        self.browser.click('#draw')
        self.browser.wait(IDLE)
        self.browser.click('circle[data-at="1,6"]')
        self.wait_for_text('#answer', 'does not satisfy')
        self.assertIn('lost with letter 3', self.browser.text('#answer'))  # the lamp is two moves ahead
        self.browser.click('#undo')
        self.browser.click('#undo')
        self.browser.wait("document.querySelector('#agent').dataset.pose === '1,8,0'")
        self.wait_for_text('#verdict', 'open')
        self.browser.click('#draw')  # drawing ends, and what was drawn stays
        self.assertEqual(self.browser.evaluate("Number(document.querySelector('#step').max)"), 1)
        self.assertIn('does not satisfy', self.browser.text('#answer'))
        self.formula('F moved')
        self.wait_for_text('#answer', 'The trajectory satisfies')
        self.browser.click('#draw')
        self.browser.click('#draw')
        self.browser.click('#message button')
        self.wait_for_text('#answer', 'certified')

    def test_tasks_without_end_have_a_lasso_and_one_can_be_drawn(self):
        self.open()
        self.say('visit the chair and the sofa forever')
        self.wait_for_text('#answer', 'for ever')
        self.assertIn('infinite words', self.browser.text('#size'))
        self.assertGreater(self.browser.evaluate("document.querySelectorAll('.route.cycle').length"), 0)
        self.formula('G F place_7')
        self.wait_for_text('#notation', '□◇place_7')
        self.browser.click('#draw')
        self.browser.wait(IDLE)
        self.browser.click('#paper')
        self.browser.evaluate("document.querySelector('#paper').focus()")
        poses = self.browser.evaluate("Number(document.querySelector('#step').max)")
        for _ in range(4):
            self.browser.press('ArrowLeft')
            self.browser.wait(IDLE)
        self.assertEqual(self.browser.evaluate("Number(document.querySelector('#step').max)"), poses + 4)
        self.browser.click('#loop')
        self.wait_for_text('#answer', 'The trajectory satisfies')

    def test_slippery_moves_have_values_and_learners_have_curves(self):
        self.open('map=grid&start=1,9,0&formula=F(easel %26 X F sofa) %26 G !chair')
        for solver, said in (('pmax', 'succeeds with probability'), ('mincost', 'actions in the mean')):
            self.choose('#solver', solver)
            self.wait_for_text('#solved', said)
            self.assertGreater(self.browser.evaluate("document.querySelectorAll('.value').length"), 50)
        self.assertIn('costs 6.00 actions', self.browser.text('#solved'))  # the route, for nothing slips
        self.browser.click('#slip')  # the middle of the slider: moves slip
        self.wait_for_text('#chance', '30 %')
        self.browser.wait("/costs (?!6.00)[0-9.]+ actions/.test(document.querySelector('#solved').textContent)")
        self.choose('#solver', 'pmax')
        self.browser.wait("/probability [0-9.]+ %/.test(document.querySelector('#solved').textContent)")
        self.assertRegex(self.browser.text('.value title'), r'^\(\d+, \d+, \d+\): [0-9.]+ %, (FORWARD|LEFT|RIGHT)$')
        self.picture('studio-values')
        self.choose('#solver', 'q-learning')
        self.wait_for_text('#solved', 'run 5 of 5')
        self.assertEqual(self.browser.evaluate("document.querySelectorAll('#curve .run').length"), 5)
        self.picture('studio-curve')
        self.choose('#solver', 'exact')
        self.browser.wait("document.querySelector('#curve').hidden")

    def test_every_export_hands_over_a_file(self):
        self.open('map=grid&start=1,9,0&formula=F easel')
        starts = {'svg': ('waymark.svg', '<?xml'), 'automaton-svg': ('automaton.svg', '<svg'),
                  'hoa': ('automaton.hoa', 'HOA: v1'), 'dot': ('automaton.dot', 'digraph'),
                  'never': ('automaton.never', 'never'), 'prism': ('product.nm', 'mdp'),
                  'latex': ('formula.tex', '\\'), 'json': ('waymark.json', '{')}
        with tempfile.TemporaryDirectory() as folder:
            self.browser.call('Browser.setDownloadBehavior', behavior='allow', downloadPath=folder)
            for kind, (name, start) in starts.items():
                self.choose('#export', kind)
                path = os.path.join(folder, name)
                chromium.wait_for(lambda: os.path.exists(path) and os.path.getsize(path) > 0, path)
                with open(path) as file:
                    self.assertTrue(file.read().startswith(start), kind)

    def test_a_link_shows_the_same_again(self):
        self.open()
        self.say(DEMO)
        self.browser.click('#next')
        link = self.browser.evaluate('location.hash.slice(1)')
        answer, notation = self.browser.text('#answer'), self.browser.text('#notation')
        self.open(link)
        self.assertEqual((self.browser.text('#answer'), self.browser.text('#notation')), (answer, notation))

    def test_a_server_beyond_this_machine_asks_for_its_token(self):
        server = subprocess.Popen([WAYMARK, 'serve', '--port', '0', '--host', '0.0.0.0'], stdout=subprocess.PIPE,
                                  text=True)
        try:
            address, token = server.stdout.readline().split()[-1].split('#')
            address = address.replace('0.0.0.0', '127.0.0.1')
            self.browser.call('Page.navigate', url=f'{address}#token=wrong')
            self.browser.wait("document.querySelector('#message')?.textContent.includes('token')")
            self.browser.open(f'{address}#{token}')
            self.say('go to the sofa')
            self.assertIn('certified', self.browser.text('#answer'))
            self.assertNotIn('token', self.browser.evaluate('location.href'))
        finally:
            server.terminate()
            server.wait(10)
            server.stdout.close()

    def test_everything_is_reached_by_keyboard(self):
        self.open()
        reached = []
        self.browser.evaluate('document.body.focus()')
        for _ in range(30):
            self.browser.press('Tab')
            reached.append(self.browser.evaluate('document.activeElement.id'))
        for name in ('map', 'open', 'semantics', 'export', 'share', 'instruction', 'go', 'paper', 'draw', 'formula'):
            self.assertIn(name, reached)
        self.browser.evaluate("document.querySelector('#paper').focus()")
        self.browser.press('ArrowRight')
        self.browser.wait("document.querySelector('#start').textContent === 'start 1,9,90'")

    def test_nothing_is_wider_than_a_phone_and_the_dark_page_is_dark(self):
        self.browser.size(390, 844, mobile=True)
        self.browser.scheme('dark')
        self.open()
        self.say(DEMO)
        self.assertLessEqual(self.browser.evaluate('document.documentElement.scrollWidth'), 390)
        self.assertEqual(self.browser.evaluate('getComputedStyle(document.body).backgroundColor'), 'rgb(21, 24, 29)')
        tops = [self.browser.evaluate(f"document.querySelector('{part}').getBoundingClientRect().top")
                for part in ('#answer', '#world', '#meaning')]
        self.assertEqual(tops, sorted(tops))
        width = "document.querySelector('#paper svg').getBoundingClientRect().width"
        before = self.browser.evaluate(width)
        self.browser.click('#larger')
        self.assertGreater(self.browser.evaluate(width), 1.3 * before)
        self.browser.click('#smaller')
        self.picture('studio-phone')

    def test_the_page_is_painted_and_answers_at_once(self):
        self.open()
        self.browser.wait("performance.getEntriesByName('first-paint').length > 0")  # a busy machine paints late
        paint = self.browser.evaluate("performance.getEntriesByName('first-paint')[0].startTime")
        seconds = sorted(self.browser.evaluate(
            "(async () => { const start = performance.now(); await fetch('/api/run', {method: 'POST', headers:"
            " {'Content-Type': 'application/json'}, body: JSON.stringify({instruction: 'go to the sofa', start:"
            " '1,9,0'})}); return performance.now() - start; })()") for _ in range(5))
        print(f'\nfirst paint {paint:.0f} ms, an instruction answered in {seconds[2]:.0f} ms (median of 5)')
        self.assertGreater(paint, 0)
        self.assertGreater(seconds[2], 0)


if __name__ == '__main__':
    if chromium.program() is None:
        print('SKIPPED: the studio is not tested in a browser: chromium is not installed')
        sys.exit(77)
    os.makedirs(FOLDER, exist_ok=True)
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])

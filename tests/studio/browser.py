"""A headless Chromium, driven over the DevTools protocol: what a person does with keyboard and mouse, and what they see."""
import base64
import json
import os
import shutil
import subprocess
import tempfile
import time
import urllib.request

import websocket

KEYS = {'Enter': ('Enter', 13, '\r'), 'ArrowUp': ('ArrowUp', 38, ''), 'ArrowLeft': ('ArrowLeft', 37, ''),
        'ArrowRight': ('ArrowRight', 39, ''), 'ArrowDown': ('ArrowDown', 40, ''), 'Tab': ('Tab', 9, ''),
        'Backspace': ('Backspace', 8, ''), ' ': ('Space', 32, ' '), 'End': ('End', 35, ''), 'Home': ('Home', 36, '')}


def program():
    return shutil.which('chromium') or shutil.which('chromium-browser')


def wait_for(holds, what, seconds=20):
    end = time.time() + seconds
    while not holds():
        if time.time() > end:
            raise AssertionError(f'within {seconds} s never: {what}')
        time.sleep(0.05)


class Browser:
    def __init__(self, width=1280, height=900):
        self.profile = tempfile.mkdtemp(prefix='waymark-studio-')
        self.process = subprocess.Popen(
            [program(), '--headless=new', '--no-sandbox', '--disable-gpu', '--no-first-run', '--remote-debugging-port=0',
             '--disable-dev-shm-usage', '--remote-allow-origins=*', f'--user-data-dir={self.profile}', f'--window-size={width},{height}', 'about:blank'],
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        port = self._port()
        with urllib.request.urlopen(f'http://127.0.0.1:{port}/json') as answer:
            page = next(target for target in json.load(answer) if target['type'] == 'page')
        self.socket = websocket.create_connection(page['webSocketDebuggerUrl'], timeout=30)
        self.number = 0
        self.problems = []  # what the page threw, and what it wrote to the console as an error
        for domain in ('Page', 'Runtime', 'DOM', 'Log', 'Network'):
            self.call(f'{domain}.enable')
        self.size(width, height)

    def _port(self):
        file = os.path.join(self.profile, 'DevToolsActivePort')
        for _ in range(300):
            if os.path.exists(file):
                with open(file) as lines:
                    text = lines.read().split()
                if text:
                    return int(text[0])
            time.sleep(0.1)
        raise RuntimeError('Chromium does not start')

    def close(self):
        try:
            self.call('Browser.close')
        except Exception:  # the connection ends with the browser
            self.process.terminate()
        self.process.wait(20)
        shutil.rmtree(self.profile, ignore_errors=True)

    def call(self, method, **params):
        self.number += 1
        self.socket.send(json.dumps({'id': self.number, 'method': method, 'params': params}))
        while True:
            message = json.loads(self.socket.recv())
            if message.get('method') == 'Runtime.exceptionThrown':
                details = message['params']['exceptionDetails']
                self.problems.append(details.get('exception', {}).get('description', details['text']))
            if message.get('id') == self.number:
                if 'error' in message:
                    raise RuntimeError(f'{method}: {message["error"]["message"]}')
                return message['result']

    def evaluate(self, expression):
        result = self.call('Runtime.evaluate', expression=expression, awaitPromise=True, returnByValue=True)
        if 'exceptionDetails' in result:
            raise RuntimeError(result['exceptionDetails']['exception']['description'])
        return result['result'].get('value')

    def wait(self, expression, seconds=20):
        end = time.time() + seconds
        while time.time() < end:
            value = self.evaluate(expression)
            if value:
                return value
            time.sleep(0.03)
        raise AssertionError(f'within {seconds} s never: {expression}')

    def open(self, address):
        self.call('Page.navigate', url='about:blank')
        self.call('Page.navigate', url=address)
        self.wait("document.readyState === 'complete' && document.body.dataset.ready")

    def size(self, width, height, mobile=False):
        self.call('Emulation.setDeviceMetricsOverride', width=width, height=height, deviceScaleFactor=1, mobile=mobile)

    def scheme(self, name):
        self.call('Emulation.setEmulatedMedia', features=[{'name': 'prefers-color-scheme', 'value': name}])

    def text(self, selector):
        return self.evaluate(f'document.querySelector({json.dumps(selector)}).textContent')

    def click(self, selector):
        place = json.dumps(selector)
        box = self.evaluate(
            f'(() => {{ const e = document.querySelector({place}); e.scrollIntoView({{block: "center"}});'
            ' const r = e.getBoundingClientRect(); return [r.x + r.width / 2, r.y + r.height / 2]; })()')
        for kind in ('mouseMoved', 'mousePressed', 'mouseReleased'):
            self.call('Input.dispatchMouseEvent', type=kind, x=box[0], y=box[1], button='none' if kind == 'mouseMoved' else 'left',
                      clickCount=0 if kind == 'mouseMoved' else 1)

    def type(self, text):
        for character in text:
            self.call('Input.dispatchKeyEvent', type='keyDown', text=character, key=character)
            self.call('Input.dispatchKeyEvent', type='keyUp', key=character)

    def press(self, key, shift=False):
        code, number, text = KEYS[key]
        event = {'key': key, 'code': code, 'windowsVirtualKeyCode': number, 'modifiers': 8 if shift else 0}
        self.call('Input.dispatchKeyEvent', type='keyDown', text=text, **event)
        self.call('Input.dispatchKeyEvent', type='keyUp', **event)

    def clear(self, selector):
        self.click(selector)
        self.evaluate(f'document.querySelector({json.dumps(selector)}).select()')
        self.press('Backspace')

    def give_file(self, selector, path):
        root = self.call('DOM.getDocument')['root']['nodeId']
        node = self.call('DOM.querySelector', nodeId=root, selector=selector)['nodeId']
        self.call('DOM.setFileInputFiles', files=[path], nodeId=node)

    def screenshot(self, path):
        picture = self.call('Page.captureScreenshot', format='png')['data']
        with open(path, 'wb') as file:
            file.write(base64.b64decode(picture))

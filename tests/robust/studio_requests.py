"""Requests to the studio: good ones with what is compared, and malformed, foreign and huge ones (docs/studio.md)."""
import json

GOOD = [
    ("GET", "/", None), ("GET", "/studio.js", None), ("GET", "/api/maps", None),
    ("POST", "/api/map", {"map": "grid"}),
    ("POST", "/api/run", {"instruction": "walk to the chair", "map": "grid", "start": "1,9,0"}),
    ("POST", "/api/words", {"instruction": "walk past the lamp to the easel", "map": "grid", "start": "1,9,0"}),
    ("POST", "/api/plan", {"formula": "F(chair & X F sofa)", "map": "grid", "start": "1,9,0"}),
    ("POST", "/api/plan", {"formula": "G F chair & G F sofa", "map": "jelly", "semantics": "infinite"}),
    ("POST", "/api/picture", {"formula": "F easel", "map": "l"}),
    ("POST", "/api/formula", {"formula": "F sofa & G !chair", "map": "grid"}),
    ("POST", "/api/explain", {"formula": "F sofa & G !chair", "map": "grid"}),
    ("POST", "/api/translate", {"formula": "F sofa", "map": "grid", "to": "dfa", "format": "hoa"}),
    ("POST", "/api/automaton", {"formula": "F(easel & X F lamp)", "map": "grid"}),
    ("POST", "/api/check", {"formula": "F sofa", "map": "grid", "trajectory": [[1, 9, 0], [1, 8, 0]]}),
    ("POST", "/api/values", {"formula": "F easel", "map": "grid", "start": "1,9,0", "slip": 0.1, "query": "pmax"}),
    ("POST", "/api/formula", {"formula": "F sofaa", "map": "grid"}),  # 422, with the place of the error
    ("POST", "/api/nothing", {}), ("GET", "/nothing", None)]

TRAVERSALS = ["/../../../../etc/passwd", "/..%2f..%2f..%2f..%2fetc/passwd", "/%2e%2e/%2e%2e/%2e%2e/etc/passwd",
              "//etc/passwd", "/api/../../../etc/passwd", "/index.html/../../../etc/passwd", "/..\\..\\etc\\passwd",
              "/data/maps/grid.json", "/.git/config", "/%00/etc/passwd", "file:///etc/passwd",
              "http://127.0.0.1/../etc/passwd", "/api/map/../../../../etc/passwd"]
MAPS = ["../../../etc/passwd", "/etc/passwd", "grid.json", "../maps/grid", "/work", "-", "\0", "a" * 5000]


def head(method, path, host, fields=()):
    lines = [f"{method} {path} HTTP/1.1", f"Host: {host}", "Connection: close", *fields]
    return ("\r\n".join(lines) + "\r\n\r\n").encode()


def request(method, path, host, body=None, fields=()):
    if body is None:
        return head(method, path, host, fields)
    data = body if isinstance(body, bytes) else json.dumps(body).encode()
    return head(method, path, host, ["Content-Type: application/json", f"Content-Length: {len(data)}", *fields]) + data


def comparable(answer):
    """An answer without what differs from time to time: the seconds."""
    status, body = answer

    def without(value):
        if isinstance(value, dict):
            return {key: without(part) for key, part in value.items() if key != "seconds"}
        return [without(part) for part in value] if isinstance(value, list) else value

    try:
        return status, without(json.loads(body))
    except ValueError:
        return status, body


def foreign(random, host):
    """A request of another site, or for a file of the machine, and the statuses that refuse it."""
    kind = random.choice(["host", "origin", "site", "type", "path", "map"])
    if kind == "host":
        other = random.choice(["evil.example", "evil.example:80", host + ".evil.example", "127.0.0.1", "localhost:1",
                               host.replace("127.0.0.1", "127.0.0.2"), "evil.example" + host[host.index(":"):]])
        return request("POST", "/api/formula", other, {"formula": "F sofa"}), (403,)
    if kind == "origin":
        origin = random.choice(["http://evil.example", "null", "https://" + host, f"http://{host}.evil.example",
                                "http://localhost"])
        return request("POST", "/api/formula", host, {"formula": "F sofa"}, [f"Origin: {origin}"]), (403,)
    if kind == "site":
        site = random.choice(["cross-site", "same-site"])
        return request("GET", "/api/maps", host, None, [f"Sec-Fetch-Site: {site}"]), (403,)
    if kind == "type":
        return head("POST", "/api/formula", host, ["Content-Type: text/plain", "Content-Length: 2"]) + b"{}", (415,)
    if kind == "path":
        return request("GET", random.choice(TRAVERSALS), host), (400, 404)
    return request("POST", "/api/map", host, {"map": random.choice(MAPS)}), (400, 404, 413, 422)


def malformed(random, host):
    """Bytes that are no request, or a request for nonsense. The answer is an error of the client, or a closed door."""
    def post(data, path="/api/plan"):
        return request("POST", path, host, data)

    good = post({"formula": "F sofa"})
    garbage = random.randbytes(random.randrange(1, 3000))
    chunked = head("POST", "/api/plan", host, ["Content-Type: application/json", "Transfer-Encoding: chunked"])
    return random.choice([
        lambda: garbage, lambda: garbage + b"\r\n\r\n", lambda: b"\r\n" * 1000, lambda: b"GET\r\n\r\n",
        lambda: b"GET / HTTP/9.9\r\n\r\n", lambda: b"GET / HTTP/1.1\r\n\r\n", lambda: b"\0" * 500 + b"\r\n\r\n",
        lambda: head("GET", "/" + "a" * random.choice([5000, 100_000]), host),
        lambda: head("GET", "/", host, [f"X-{i}: {i}" for i in range(5000)]),
        lambda: head("GET", "/", host, ["X: " + "b" * 200_000]),
        lambda: head("GET", "/", host, ["no colon", ": no name", "Host: twice"]),
        lambda: head(random.choice(["PUT", "DELETE", "TRACE", "CONNECT", "get", "OPTIONS"]), "/api/plan", host),
        lambda: head("POST", "/api/plan", host, ["Content-Type: application/json", "Content-Length: " + random.choice(
            ["-1", "abc", "99999999999999999999", "1e3", "0x10", ""])]) + b"{}",
        lambda: chunked + random.choice([b"zz\r\n{}\r\n0\r\n\r\n", b"ffffffffffffffff\r\n{}", b"-2\r\n{}\r\n0\r\n\r\n",
                                         b"2\r\n{}", b"0\r\n\r\n"]),
        lambda: post(garbage), lambda: post(b"{"), lambda: post(b"[" * random.choice([10, 5000, 500_000])),
        lambda: post(b'{"formula": "F \xff\xfe sofa"}'), lambda: post(b'{"formula": "F \\u0000 sofa"}'),
        lambda: post({"formula": "(" * random.choice([10, 10_000, 100_000])}), lambda: post({"formula": "X " * 30_000}),
        lambda: post({"formula": "F a", "formula2": [{}] * 50_000}),
        lambda: post({"formula": 7, "map": [], "start": {}}),
        lambda: post({"formula": "F sofa", "start": random.choice(["1e9,9,0", "a,b,c", "1,9,45", "-1,-1,-1", ""])}),
        lambda: post({"formula": "F sofa", "trajectory": [[1, 9]] * 3}, "/api/check"),
        lambda: post({"formula": "F sofa", "trajectory": [[1, 9, 0]], "cycle": -7}, "/api/check"),
        lambda: post({"formula": "F sofa", "slip": random.choice([-1, 2, 1e308, "x"])}, "/api/values"),
        lambda: post({"instruction": "walk " * 2000}, "/api/run"), lambda: post({"instruction": ""}, "/api/run"),
        lambda: post({"name": "yard", "nodes": [{"x": 1e300, "y": 0}], "edges": [{}]}, "/api/maps"),
        lambda: good[:random.randrange(1, len(good))],
        lambda: bytes(b ^ (1 << random.randrange(8)) if random.random() < 0.02 else b for b in good)])()

"""Random damage to bytes: what disks, transfers and editors do to files, and what an attacker writes instead."""
import struct

import seal

VERSION_AT, KIND_AT, HEADER = 8, 12, 16  # docs/formats/corpus-and-models.md: magic, version, kind, dialect


def places(random, data, count):
    return sorted(random.randrange(len(data) + 1) for _ in range(count))


def truncated(random, data):
    return data[:random.choice([random.randrange(len(data)), random.randrange(min(len(data), 64)),
                                len(data) - random.randrange(1, min(len(data), 64))])]


def extended(random, data):
    return data + random.choice([b"\0", random.randbytes(random.randrange(1, 64)), data[-8:], data[:4096]])


def flipped(random, data):
    out = bytearray(data)
    for _ in range(random.choice([1, 1, 1, 2, 8, 64])):
        out[random.randrange(len(out))] ^= 1 << random.randrange(8)
    return bytes(out)


def overwritten(random, data):
    first, last = places(random, data, 2)
    last = min(last, first + random.choice([1, 8, 512, 4096, 1 << 20]))
    block = random.choice([lambda n: bytes(n), lambda n: b"\xff" * n, random.randbytes])(last - first)
    return data[:first] + block + data[last:]


def other_version(random, data):
    version = random.choice([0, 1, 13, 14, 16, 255, 1 << 31, random.randrange(1 << 32)])
    return data[:VERSION_AT] + struct.pack("<I", version) + data[KIND_AT:]


def other_kind(random, data):
    return data[:KIND_AT] + struct.pack("<2H", random.choice([0, 1, 2, 3, 65535]),
                                        random.choice([0, 1, 2, 65535])) + data[HEADER:]


def aligned(random, data, count):
    return [place // 8 * 8 for place in places(random, data, count)]


def swapped(random, data):
    a, b, c, d = aligned(random, data, 4)
    return data[:a] + data[c:d] + data[b:c] + data[a:b] + data[d:]


def removed(random, data):
    first, last = aligned(random, data, 2)
    return data[:first] + data[last:]


def doubled(random, data):
    first, last = aligned(random, data, 2)
    return data[:last] + data[first:last] + data[last:]


def big_number(random, data):
    """An aligned number becomes a great one: a length that the file does not have."""
    at = random.randrange(max(1, len(data) // 8)) * 8
    number = random.choice([1 << 63, (1 << 64) - 1, 1 << 32, 1 << 61, len(data), len(data) // 8 + 1])
    return data[:at] + struct.pack("<Q", number) + data[at + 8:]


def something_else(random, data):
    return random.choice([b"", b"\n", b"waymark\n", b"waymark\n" + bytes(8), b"<html>no model</html>\n", bytes(4096),
                          b"{}", b"[]", b"null", random.randbytes(random.randrange(1, 10_000)), data[:8] * 1000])


ANY = (truncated, extended, flipped, overwritten, swapped, removed, doubled, something_else)
OF_MODELS = ANY + (other_version, other_kind, big_number)
UNDER_SEAL = (flipped, overwritten, other_version, other_kind, swapped, removed, doubled, big_number)


def damaged(random, data, ways):
    """The name of a way, and bytes that differ from `data`."""
    while True:
        way = random.choice(ways)
        out = way(random, data)
        if out != data:
            return way.__name__, out


def resealed(random, data):
    """Damage under a checksum that fits: the checks behind the checksum have to find it, or the model is another one.

    Most damage falls on the first bytes, which hold the lists and sizes."""
    body = data[:-8]
    size = random.choice([64, 512, 4096, len(body)])
    name, out = damaged(random, body[:size], UNDER_SEAL)
    return name, seal.sealed(out + body[size:])


def difference(before, after):
    """What reproduces `after` from `before`: the first and last bytes that differ, in hexadecimal."""
    first = next((i for i, (a, b) in enumerate(zip(before, after)) if a != b), min(len(before), len(after)))
    same_end = 0
    while same_end < min(len(before), len(after)) - first and before[-1 - same_end] == after[-1 - same_end]:
        same_end += 1
    new = after[first:len(after) - same_end]
    return (f"bytes {first} to {len(before) - same_end} of {len(before)} become {len(new)} bytes: "
            f"{new[:200].hex()}{' …' if len(new) > 200 else ''}")

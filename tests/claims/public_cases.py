#!/usr/bin/env python3
"""Small cases after public reports to neighbouring tools, where a file of them is present.

usage: public_cases.py WAYMARK [--cases FILE] [--only ID]

FILE has a JSON object a line; without --cases, $WAYMARK_SHARED/cases/cases.jsonl, else the same in ../shared beside the
source tree. The keys: `id`, `kind`, `how_to_try` (a shell command), `got` (what an older version printed) and `verdict`
(of that version). What was right must end with the same exit codes; what was changed since is listed below, with texts
that the answer must have. Cases in English measure reading; they are counted apart. Exit code 77: there is no file.
"""
import argparse
import json
import os
import re
import subprocess
import sys
import tempfile

# By case: what the output must contain. The cases changed on purpose since the file was written.
MENDED = {
    'syn-02': ['AP: 2 "a" "b"', "note: 'GFa' is read as one proposition"],
    'syn-06': ["'not' means nothing here (did you mean '!'?", 'rc=21'],
    'syn-16': ['this is a TLSF specification', 'rc=21'],
    'mon-05': ['trace 1: not satisfied', 'trace 2: satisfied', 'rc=10'],
    'mon-06': ['error: ', 'rc=21'],
    'mon-08': ['semicolon rc=0', 'tab rc=0', 'yesno rc=10', 'short rc=21', 'twice rc=21'],
    'mon-09': ['satisfied\nrc=0\nsatisfied\nrc=0', 'with --time-unit'],
    'mon-10': ['not satisfied: it ends too early\nrc=10', 'this is an XES log', 'rc=21'],
    'mon-12': ["'a&!b' is no name", '({b})ω => 0 satisfied', '({b})ʷ => 0 satisfied'],
    'prism-15': ['0.999995000012', '4.99998774739e-06\nrc=0\nP=?'],
    'prism-19': ['|| is not read', '(F x=2) | (F x=1) ]  1\nrc=0'],
    'prism-38': ['CTL'],
}


def exit_codes(text):
    return re.findall(r'(?:rc=| => )(\d+)', text)


def run(case, program):
    path = os.path.dirname(os.path.abspath(program)) + os.pathsep + os.environ['PATH']
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run(['bash', '-c', case['how_to_try']], cwd=folder, env={**os.environ, 'PATH': path},
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=120, check=False)
        apart = subprocess.run(['bash', '-c', case['how_to_try']], cwd=folder, env={**os.environ, 'PATH': path},
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=120, check=False)
    return done.stdout, apart.stdout + apart.stderr  # as a person sees it, and both parts whole


def complaint(case, texts):
    if case['id'] in MENDED:
        missing = [part for part in MENDED[case['id']] if not any(part in text for text in texts)]
        return f'without {missing}' if missing else None
    if len(case['got']) >= 300:  # the file has the beginning alone
        asked = exit_codes(case['got'])
        return None if exit_codes(texts[0])[:len(asked)] == asked else f'exit codes other than {asked}'
    asked = exit_codes(case['got'])
    return None if sorted(exit_codes(texts[0])) == sorted(asked) else f'exit codes other than {asked}'


def main():
    root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
    shared = os.environ.get('WAYMARK_SHARED', os.path.join(os.path.dirname(root), 'shared'))
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('waymark')
    parser.add_argument('--cases', default=os.path.join(shared, 'cases', 'cases.jsonl'))
    parser.add_argument('--only')
    arguments = parser.parse_args()
    if not os.path.exists(arguments.cases):
        print(f'SKIPPED: no cases at {arguments.cases}')
        sys.exit(77)
    with open(arguments.cases, encoding='utf-8') as file:
        cases = [json.loads(line) for line in file]
    failed = english = tried = 0
    for case in cases:
        if arguments.only and case['id'] != arguments.only:
            continue
        if case['kind'] in ('English', 'English on a map'):
            english += 1
            continue
        tried += 1
        texts = run(case, arguments.waymark)
        said = complaint(case, texts)
        if said:
            failed += 1
            print(f"{case['id']} ({case['kind']}): {said}; asked for: {case['right_answer']}\n  try: "
                  f"{case['how_to_try']}\n  got: {texts[0]}")
    print(f'{tried} cases tried, {failed} wrong; {english} in English are not tried here')
    sys.exit(1 if failed or not tried else 0)


if __name__ == '__main__':
    main()

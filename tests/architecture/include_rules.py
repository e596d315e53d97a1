#!/usr/bin/env python3
"""Reads the #include lines of a source tree and lists those that break the rules of rules.py. Exit status 1 if any do.

Usage: include_rules.py TOP_OF_THE_REPOSITORY
"""

import pathlib
import re
import sys

import rules

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)


def folder_of(path):
    """The folder of the rules that a path relative to the top belongs to: "src/mesh", "io"."""
    parts = pathlib.PurePosixPath(path).parts
    return "/".join(parts[:2]) if parts[0] == "src" else parts[0]


def read_tree(top):
    """{path relative to the top: [(delimiter, name) of each include]} of all sources the rules speak of."""
    tree = {}
    for root in ("src", "io", "oracles"):
        for path in sorted((top / root).rglob("*")):
            if path.suffix in (".h", ".cpp"):
                text = path.read_text(encoding="utf-8")
                tree[path.relative_to(top).as_posix()] = INCLUDE.findall(text)
    return tree


def resolve(name, tree):
    """Path of one of our own headers, included as "mesh/topology.h" or "io/mesh_reader.h"; None if it is not ours."""
    for candidate in ("src/" + name, name):
        if candidate in tree:
            return candidate
    return None


def opened(folder, may_include):
    """Folders and single headers that files of a folder may include: what is listed, and what the listed folders may."""
    reached = set()
    waiting = list(may_include[folder])
    while waiting:
        entry = waiting.pop()
        if entry not in reached:
            reached.add(entry)
            waiting += may_include.get(entry, [])
    return reached


def third_party(name):
    """The third party a header belongs to, or None."""
    for party, (beginnings, _) in rules.THIRD_PARTIES.items():
        if name.startswith(beginnings):
            return party
    return None


def is_system(name):
    is_standard = "." not in name and "/" not in name
    return is_standard or name in rules.SYSTEM_HEADERS or name.startswith(rules.SYSTEM_PREFIXES)


def own_include_violations(path, includes, tree):
    folder = folder_of(path)
    if folder not in rules.MAY_INCLUDE:
        return [f"{path}: folder {folder} is not in the table of rules.py"]
    allowed = opened(folder, rules.MAY_INCLUDE)
    found = []
    for delimiter, name in includes:
        target = resolve(name, tree)
        if target is None:
            if delimiter == '"':
                found.append(f'{path}: "{name}" is not a header of ours written as folder/header.h')
        elif folder_of(target) != folder and folder_of(target) not in allowed and target not in allowed:
            found.append(f"{path}: {folder} may not include {target}")
    return found


def third_party_violations(path, includes, tree):
    found = []
    for delimiter, name in includes:
        if delimiter == '"' or resolve(name, tree) is not None or is_system(name):
            continue
        party = third_party(name)
        if party is None:
            found.append(f"{path}: <{name}> belongs to no third party of rules.py")
        elif folder_of(path) not in rules.THIRD_PARTIES[party][1]:
            found.append(f"{path}: {party} may not be named in {folder_of(path)} (<{name}>)")
    return found


def shared_headers(tree):
    """{header: who shares it} for headers that another folder includes, directly or through other headers."""
    shared = {}
    waiting = [
        (resolve(name, tree), path)
        for path, includes in tree.items()
        for _, name in includes
        if resolve(name, tree) and folder_of(resolve(name, tree)) != folder_of(path)
    ]
    while waiting:
        header, user = waiting.pop()
        if header not in shared:
            shared[header] = user
            waiting += [(resolve(name, tree), header) for _, name in tree[header] if resolve(name, tree)]
    return shared


def shared_header_violations(tree):
    return [
        f"{header}: names {third_party(name)} (<{name}>) and is shared with another folder ({user})"
        for header, user in sorted(shared_headers(tree).items())
        for _, name in tree[header]
        if resolve(name, tree) is None and third_party(name)
    ]


def violations(tree):
    found = []
    for path, includes in sorted(tree.items()):
        found += own_include_violations(path, includes, tree)
        found += third_party_violations(path, includes, tree)
    return found + shared_header_violations(tree)


def main():
    tree = read_tree(pathlib.Path(sys.argv[1]))
    if not tree:
        print(f"{sys.argv[1]}: no sources found", file=sys.stderr)
        return 1
    found = violations(tree)
    for line in found:
        print(line)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""Units for clang-tidy: files of a folder that are compiled alike are read as one, since most of its time goes into
the headers that they share.

    scripts/tidy-units.py COMPILE_COMMANDS OUT FILE...

Writes OUT/*.cpp and OUT/compile_commands.json, and prints the units' paths."""

import json
import pathlib
import shlex
import sys

# Not to be read together: their files have the same local names (a table a file, a device a file), or include the
# same generated table.
APART = {"isa_sim/isa", "peripheral_model", "compiler/target/BfinMCTargetDesc.cpp"}


def flags_of(command):
    """A command's options, without its input, its output and g++'s precompiled header."""
    words = iter(shlex.split(command)[1:])
    flags = []
    for word in words:
        if word in ("-o", "-c", "-include"):
            next(words)
        elif word != "-Winvalid-pch" and not word.endswith("c++"):  # a launcher's compiler
            flags.append(word)
    return tuple(flags)


def units_of(database, files):
    """[(name, flags, files)], in the order of the files."""
    commands = {}
    for entry in database:
        commands.setdefault(entry["file"], entry)
    groups = {}
    for file in files:
        path = str(pathlib.Path(file).resolve())
        if path not in commands:
            sys.exit(f"tidy-units: {file} is compiled by no target")
        folder = str(pathlib.Path(file).parent)
        alone = file if folder in APART or file in APART else ""
        groups.setdefault((folder, alone, flags_of(commands[path]["command"])), []).append(path)
    for number, ((folder, _, flags), paths) in enumerate(groups.items()):
        yield f"{folder.replace('/', '_')}_{number}.cpp", flags, paths


def main():
    database = json.loads(pathlib.Path(sys.argv[1]).read_text())
    out = pathlib.Path(sys.argv[2]).resolve()
    out.mkdir(parents=True, exist_ok=True)
    commands = []
    for name, flags, paths in units_of(database, sys.argv[3:]):
        unit = out / name
        if len(paths) == 1:
            unit = pathlib.Path(paths[0])
        else:
            unit.write_text("".join(
                f'#include "{path}"  // NOLINT(bugprone-suspicious-include)\n' for path in paths))
        commands.append({"directory": str(out), "file": str(unit),
                         "arguments": ["c++", *flags, "-c", str(unit)]})
        print(unit)
    (out / "compile_commands.json").write_text(json.dumps(commands, indent=1))


main()

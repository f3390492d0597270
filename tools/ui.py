#!/usr/bin/env python3
"""Drives the window gcm-gui like a user: reads the description that the window writes, moves the
mouse and presses keys.

    ui.py FILE wait EXPRESSION [SECONDS]   waits until the expression is true
    ui.py FILE show EXPRESSION             prints the value of the expression
    ui.py FILE click|double|ctrl-click GROUP NAME
                                           GROUP: widgets, rows, nodes, ports or candidates; or
                                           screen with a NAME such as 120,80
    ui.py FILE drag GROUP NAME GROUP NAME  drags from the middle of one thing to the middle of another
    ui.py FILE key KEY...                  such as ctrl+z
    ui.py FILE type TEXT

`gcm-gui --describe-ui FILE` writes the description to FILE. An expression is Python; its variables are the parts of the
description: facts, ports, rows, widgets, nodes and candidates. The exit code is 1, with a message, if a thing does not
exist or an expression does not become true.
"""
import json
import subprocess
import sys
import time

TIMEOUT = 60.0  # s; long enough for a busy machine


class Missing(Exception):
    pass


def description(file):
    with open(file, encoding="utf-8") as stream:
        return json.load(stream)


def holds(file, expression):
    """The value of the expression, or False while a part of it does not exist yet."""
    try:
        return eval(expression, {"__builtins__": {"abs": abs, "all": all, "len": len, "any": any, "set": set}},
                    description(file))
    except (KeyError, IndexError, TypeError, OSError, ValueError):
        return False


def wait(file, expression, seconds=TIMEOUT):
    deadline = time.monotonic() + float(seconds)
    while not holds(file, expression):
        if time.monotonic() >= deadline:
            raise Missing(f"in {seconds} s the window never showed: {expression}")
        time.sleep(0.1)


def middle(file, group, name):
    """The position of a thing after it has stopped moving."""
    if group == "screen":
        return tuple(int(number) for number in name.split(","))
    wait(file, f"{name!r} in {group}")
    last = None
    while True:
        thing = description(file)[group].get(name)
        if thing is None:
            raise Missing(f"{name} of {group} has gone")
        left, top, width, height = thing["rect"] if isinstance(thing, dict) else thing
        place = (left + width // 2, top + height // 2)
        if place == last:
            return place
        last = place
        time.sleep(0.3)


def xdotool(*words):
    subprocess.run(["xdotool", *map(str, words)], check=True)


def click(file, group, name, repeat=1, modifier=None):
    x, y = middle(file, group, name)
    xdotool("mousemove", "--sync", x, y)
    if modifier:
        xdotool("keydown", modifier)
    xdotool("click", "--repeat", repeat, "--delay", 60, 1)
    if modifier:
        xdotool("keyup", modifier)


def drag(file, from_group, from_name, to_group, to_name):
    start, end = middle(file, from_group, from_name), middle(file, to_group, to_name)
    xdotool("mousemove", "--sync", *start, "mousedown", 1)
    for step in range(1, 11):
        xdotool("mousemove", "--sync", *(a + (b - a) * step // 10 for a, b in zip(start, end)))
        time.sleep(0.02)
    if from_group == "screen":
        time.sleep(0.5)  # so that the window of another program can say that it accepts the drop
    xdotool("mouseup", 1)


def main(file, verb, *words):
    if verb == "wait":
        wait(file, *words)
    elif verb == "show":
        print(json.dumps(holds(file, words[0])))
    elif verb in ("click", "double", "ctrl-click"):
        click(file, *words, repeat=2 if verb == "double" else 1, modifier="ctrl" if verb == "ctrl-click" else None)
    elif verb == "drag":
        drag(file, *words)
    elif verb == "key":
        xdotool("key", "--clearmodifiers", *words)
    elif verb == "type":
        xdotool("type", "--delay", 15, *words)
    else:
        raise Missing(f"no verb {verb}")


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    try:
        main(*sys.argv[1:])
    except Missing as missing:
        sys.exit(f"ui: {missing}")

"""Devices with planted faults: `radcomp answer` behind a proxy that spoils what it is told or what it answers.

    python3 faulty.py FAULT PATH-OF-RADCOMP
"""

import json
import os
import subprocess
import sys
import time
import zlib

FAULT, RADCOMP = sys.argv[1:]


def main():
    sound = subprocess.Popen([RADCOMP, "answer"], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
    for line in sys.stdin:
        request = json.loads(line)
        before = BEFORE.get(FAULT)
        if before:
            before(request)
        sound.stdin.write((json.dumps(request) + "\n").encode())
        sound.stdin.flush()
        answer = json.loads(sound.stdout.readline())
        after = AFTER.get(FAULT)
        if after:
            after(request, answer)
        print(json.dumps(answer), flush=True)


def one_in(request, count):
    """Whether a program is one of those that the fault shows in: by what it says, so that the same ones are each time."""
    return zlib.crc32(json.dumps(request["blocks"]).encode()) % count == 0


# What the device is told.


def wrong_side(request):
    for block in request["blocks"]:
        code = block.get("compensation")
        if code in ("left", "right"):
            block["compensation"] = "right" if code == "left" else "left"


def lost_on_z_only(request):
    on = False
    for block in request["blocks"]:
        on = {"left": True, "right": True, "off": False}.get(block.get("compensation"), on)
        if on and block["movement"] == "none":
            block["compensation"] = "off"


def short_look_ahead(request):
    allowed = int(request["profile"]["compensation.non-moving-allowed"])
    request["profile"]["compensation.non-moving-allowed"] = str(max(allowed - 1, 0))


# What it answers.


def mitre_without_limit(request, answer):
    """An acute outer corner is not squared off."""
    steps, at, before, mitred = answer["steps"], [0.0, 0.0], [0.0, 0.0], []
    for index, step in enumerate(steps):
        flat = step["shape"] == "line" and step["clause"] == "TRC-CORNER-08" and not step["main"]
        following = next((later for later in steps[index + 1:] if "end" in later), None)
        if flat and mitred and mitred[-1]["shape"] == "line" and following and following["shape"] == "line":
            tip = meet(before, at, step["end"], following["end"])
            if tip:
                mitred[-1]["end"] = tip
                at = step["end"]
                continue
        mitred.append(step)
        if "end" in step:
            before, at = at, step["end"]
    answer["steps"] = mitred


def meet(p, q, r, s):
    """Where the line through p and q meets the line through r and s."""
    u, v = [q[0] - p[0], q[1] - p[1]], [s[0] - r[0], s[1] - r[1]]
    cross = u[0] * v[1] - u[1] * v[0]
    if abs(cross) < 1e-9:
        return None
    t = ((r[0] - p[0]) * v[1] - (r[1] - p[1]) * v[0]) / cross
    return [p[0] + t * u[0], p[1] + t * u[1]]


def negative_radius(request, answer):
    """A tool that does not fit inside an arc runs on a circle of negative radius, the other way round."""
    alarm = answer["alarm"]
    if not alarm or alarm["alarm"] != "radius-too-small":
        return
    arc = request["blocks"][alarm["block"]]["movement"]["arc"]
    end = [float(number) for number in arc["end"]]
    answer["alarm"] = None
    answer["steps"].append({
        "block": alarm["block"],
        "shape": "arc",
        "end": end,
        "centre": [end[0] - 1.0, end[1]],
        "direction": "cw" if arc["direction"] == "ccw" else "ccw",
    })


def drift(request, answer):
    for index, step in enumerate(answer["steps"]):
        if "end" in step:
            step["end"][0] += 1e-6 * index


def not_a_number(request, answer):
    ends = [step["end"] for step in answer["steps"] if "end" in step]
    if one_in(request, 60) and ends:
        ends[-1][1] = float("nan")


def hang(request, answer):
    if one_in(request, 200):
        time.sleep(3600)


def crash(request, answer):
    if one_in(request, 60):
        os.abort()


def other_id(request, answer):
    if one_in(request, 60):
        answer["id"] = str(int(answer["id"]) + 1)


# Beyond the ten: what a process can do to its output.


def half_line(request, answer):
    if one_in(request, 60):
        sys.stdout.write(json.dumps(answer)[:20])
        sys.stdout.flush()
        sys.exit(0)


def flood(request, answer):
    if one_in(request, 150):
        while True:
            sys.stdout.write("x" * 65536)


def twice(request, answer):
    if one_in(request, 60):
        print(json.dumps(answer))


def chatter(request, answer):
    if one_in(request, 60):
        print("starting up ...")


BEFORE = {"wrong-side": wrong_side, "lost-on-z-only": lost_on_z_only, "short-look-ahead": short_look_ahead}
AFTER = {
    "mitre-without-limit": mitre_without_limit,
    "negative-radius": negative_radius,
    "drift": drift,
    "nan": not_a_number,
    "hang": hang,
    "crash": crash,
    "other-id": other_id,
    "half-line": half_line,
    "flood": flood,
    "twice": twice,
    "chatter": chatter,
}

if FAULT != "none" and FAULT not in BEFORE and FAULT not in AFTER:
    sys.exit(f"there is no fault {FAULT}")
main()

"""An adapter with one of the mistakes that a first adapter has: `radcomp device-kit python`, spoilt.

    python3 clumsy.py MISTAKE
"""

import json
import sys
import time

MISTAKE = sys.argv[1]


def main():
    count = 0
    for line in sys.stdin:
        count += 1
        request = json.loads(line)
        if MISTAKE == "log":
            print("one program")
        if MISTAKE == "silent":
            time.sleep(3600)
        steps = path(request["blocks"])
        if MISTAKE == "forgetful" and count > 60:
            steps = [step for step in steps if step["shape"] != "line"] or steps
        print(json.dumps({"id": request["id"], "steps": steps, "alarm": None}), flush=True)


def path(blocks):
    steps, at, offset, radius = [], [0.0, 0.0], 0.0, 0.0
    for index, block in enumerate(blocks):
        radius = float(block.get("radius", radius))
        code = block.get("compensation")
        if code:
            offset = {"left": radius, "right": -radius, "off": 0.0}[code]
            offset *= {"other-side": -1, "half": 0.5, "ignores": 0}.get(MISTAKE, 1)
        step = {"block": index + (MISTAKE == "from-one"), "rapid": block.get("rapid", False) and MISTAKE != "never-rapid"}
        movement = block["movement"]
        if movement == "none" or "dummy" in movement:
            if MISTAKE != "no-hold":
                steps.append({"block": step["block"], "shape": "hold"})
            continue
        kind = "line" if "line" in movement else "arc"
        to = [float(number) for number in movement[kind]["end"]]
        end = [to[0], to[1] + offset]
        if MISTAKE == "inches":
            end = [end[0] / 25.4, end[1] / 25.4]
        if MISTAKE == "swapped":
            end.reverse()
        if MISTAKE == "relative":
            end = [end[0] - at[0], end[1] - at[1]]
        step.update(shape=kind, end=end)
        if kind == "arc":
            centre = [float(number) for number in movement["arc"]["centre"].get("from-start", [0, 0])]
            if MISTAKE != "centre":
                centre = [centre[0] + at[0], centre[1] + at[1]]
            direction = movement["arc"]["direction"]
            if MISTAKE == "sense":
                direction = "cw" if direction == "ccw" else "ccw"
            step.update(centre=centre, direction=direction, rapid=False)
        steps.append(step)
        at = to
    return steps


main()

#!/usr/bin/env python3
"""An adapter between radcomp and a control: JSON Lines in, JSON Lines out.

    radcomp ping "pipe:python3 adapter.py"
    radcomp certify "pipe:python3 adapter.py" --profile NAME

As it stands it knows programs without compensation, and says of every other one that it is not supported.
Put your control into compensated().
"""

import json
import sys

# The number of the protocol that this adapter knows, and what may stand in its blocks. Rather than read past what it does not
# know, it says that the program is not supported.
PROTOCOL = 2
KNOWN = {
    "movement", "rapid", "compensation", "radius", "corner", "approach", "stops_look_ahead", "not_in_mode",
}


def main():
    for line in sys.stdin:
        request = json.loads(line)
        answer = {"id": request["id"]}
        try:
            answer["steps"], answer["alarm"] = path(request)
        except NotImplementedError as reason:
            answer = {"id": request["id"], "unsupported": str(reason)}
        # allow_nan=False: JSON has no NaN, and radcomp takes none.
        print(json.dumps(answer, allow_nan=False), flush=True)


def path(request):
    """The steps of the tool's centre, and the alarm: None or {"block": 3, "alarm": "reversal"}."""
    if request["radcomp"] != PROTOCOL:
        raise NotImplementedError(f"protocol {request['radcomp']}: this adapter knows {PROTOCOL}")
    for block in request["blocks"]:
        for field in block.keys() - KNOWN:
            raise NotImplementedError(f"blocks with {field}")
    if any(block.get("compensation") in ("left", "right") for block in request["blocks"]):
        return compensated(request)
    return uncompensated(request["blocks"]), None


def compensated(request):
    # The program as your control reads it: request["program"], G-code, with the tool radii request["tools"];
    # or request["blocks"], resolved. Numbers of a program are exact decimals in strings.
    raise NotImplementedError("compensation: put your control here")


def uncompensated(blocks):
    """Without compensation the centre follows the program."""
    steps, at = [], [0.0, 0.0]
    for index, block in enumerate(blocks):
        movement, rapid = block["movement"], block.get("rapid", False)
        if movement == "none" or "dummy" in movement:
            steps.append({"block": index, "shape": "hold"})
        elif "line" in movement:
            end = point(movement["line"]["end"])
            steps.append({"block": index, "shape": "line", "end": end, "rapid": rapid})
            at = end
        elif "arc" in movement:
            arc = movement["arc"]
            if "from-start" not in arc["centre"]:
                raise NotImplementedError("an arc with its radius")
            offset, end = point(arc["centre"]["from-start"]), point(arc["end"])
            steps.append({
                "block": index,
                "shape": "arc",
                "end": end,
                "centre": [at[0] + offset[0], at[1] + offset[1]],  # absolute
                "direction": arc["direction"],
                "full": end == at,
            })
            at = end
        else:
            raise NotImplementedError(f"the movement {next(iter(movement))}")
    return steps


def point(decimals):
    return [float(decimal) for decimal in decimals]


main()

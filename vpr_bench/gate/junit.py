"""A judgement as JUnit's XML, which servers for continuous integration read: one test case per cell."""

import xml.etree.ElementTree as ET
from collections.abc import Sequence
from dataclasses import replace

from vpr_bench.gate.verdict import Judgement, Verdict
from vpr_bench.gate.words import failure

SUITE = "vpr-bench gate"
_SPECIAL = ("\t", "\n", "\r")


def to_junit(judgement: Judgement) -> str:
    """Write the test suite.

    What failed or is missing is a failure, what could not be judged an error, and what is new is skipped.

    Parameters
    ----------
    judgement : Judgement
        What was found; what XML cannot hold is left out of names.
    """
    if judgement.idle:  # servers take an empty suite, or one that was skipped, for a good one
        nothing = Verdict(judgement.summary(), "", "fail", reasons=["no cell of the baseline was judged"])
        judgement = replace(judgement, verdicts=[*judgement.verdicts, nothing])
    verdicts = judgement.verdicts
    counts = {
        "tests": str(len(verdicts)),
        "failures": str(judgement.count("fail") + judgement.count("missing")),
        "errors": str(judgement.count("error")),
        "skipped": str(judgement.count("new")),
        "time": _seconds(verdicts),
    }
    root = ET.Element("testsuites", {"name": SUITE, **counts})
    suite = ET.SubElement(root, "testsuite", {"name": SUITE, **counts})
    for verdict in verdicts:
        _case(suite, verdict)
    ET.indent(root, " ")
    return '<?xml version="1.0" encoding="utf-8"?>\n' + ET.tostring(root, encoding="unicode") + "\n"


def _case(suite: ET.Element, verdict: Verdict) -> None:
    names = {"classname": clean(verdict.protocol) or SUITE, "name": clean(verdict.label)}
    case = ET.SubElement(suite, "testcase", {**names, "time": _seconds([verdict])})
    facts = {change.metric: f"{change.after:.6f}" for change in verdict.metrics}
    facts |= {f"{change.metric} in the baseline": f"{change.before:.6f}" for change in verdict.metrics}
    facts |= {"lost": str(len(verdict.lost)), "gained": str(len(verdict.gained))} if verdict.metrics else {}
    facts |= {"run": str(verdict.run)} if verdict.run else {}
    if facts:
        properties = ET.SubElement(case, "properties")
        for name, value in facts.items():
            ET.SubElement(properties, "property", {"name": clean(name), "value": clean(value)})
    tag = {"fail": "failure", "missing": "failure", "error": "error", "new": "skipped"}.get(verdict.outcome)
    if tag is not None:
        message = clean("; ".join(verdict.reasons))
        told = ET.SubElement(case, tag, {"message": message, **({} if tag == "skipped" else {"type": verdict.outcome})})
        told.text = clean(failure(verdict))
    elif verdict.notes:
        ET.SubElement(case, "system-out").text = clean("\n".join(verdict.notes))


def clean(text: str) -> str:
    r"""Leave out what XML 1.0 cannot hold, even escaped.

    Examples
    --------
    >>> clean("a\x00b\x1b[31mc")
    'ab[31mc'
    """
    return "".join(mark for mark in text if mark in _SPECIAL or _allowed(ord(mark)))


def _allowed(code: int) -> bool:
    return 0x20 <= code <= 0xD7FF or 0xE000 <= code <= 0xFFFD or 0x10000 <= code <= 0x10FFFF


def _seconds(verdicts: Sequence[Verdict]) -> str:
    return f"{sum(one.seconds for one in verdicts):.3f}"

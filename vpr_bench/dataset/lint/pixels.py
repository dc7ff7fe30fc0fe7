"""What is wrong with the pictures of a traverse, from one :func:`~vpr_bench.dataset.lint.survey.survey` of it."""

from vpr_bench.dataset.lint.finding import Finding, counted, listed, share
from vpr_bench.dataset.lint.survey import DARK, Survey
from vpr_bench.types.traverse import Traverse

_NAMED = 5
"""How many images or stretches are named one by one."""


def find_undecodable(traverse: Traverse, survey: Survey) -> list[Finding]:
    """Name the images that cannot be decoded; of very many the first ones, and how many more there are."""
    faults = list(survey.faults.items())
    findings = [
        Finding("does-not-decode", "error", traverse.name_of(index), message) for index, message in faults[:_NAMED]
    ]
    if len(faults) > _NAMED:
        message = f"{len(faults) - _NAMED:,} more of {counted(len(traverse), 'image')} cannot be decoded"
        findings.append(Finding("does-not-decode", "error", traverse.name, message))
    return findings


def find_mixed_sizes(traverse: Traverse, survey: Survey) -> list[Finding]:
    """Find images of different sizes in one traverse."""
    if len(survey.sizes) < 2:
        return []
    sizes = [f"{count:,} of {width}×{height}" for (width, height), count in survey.sizes.most_common()]
    return [Finding("mixed-sizes", "warning", traverse.name, f"images of different sizes: {listed(sizes, _NAMED)}")]


def find_dark(traverse: Traverse, survey: Survey) -> list[Finding]:
    """Find stretches in which nothing can be seen."""
    return _find_stretches("dark", f"black (mean below {DARK:g} of 255)", traverse, survey.dark)


def find_frozen(traverse: Traverse, survey: Survey) -> list[Finding]:
    """Find stretches in which the picture does not change: many frames are then equally right."""
    return _find_stretches("frozen", "one picture over and over", traverse, survey.frozen)


def _find_stretches(check: str, what: str, traverse: Traverse, stretches: list[range]) -> list[Finding]:
    if not stretches:
        return []
    named = [_name(traverse, stretch) for stretch in stretches]
    message = f"{what}: {share(sum(map(len, stretches)), len(traverse), 'image')}: {listed(named, _NAMED)}"
    return [Finding(check, "warning", traverse.name, message)]


def _name(traverse: Traverse, stretch: range) -> str:
    first, last = traverse.name_of(stretch[0]), traverse.name_of(stretch[-1])
    return first if len(stretch) == 1 else f"{first} to {last} ({len(stretch)})"

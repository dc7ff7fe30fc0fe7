"""Place labels in words."""

from vpr_bench.maps.answer import Place


def place_text(place: Place | None) -> str:
    """Write a place label: a number, or a position in metres."""
    if place is None:
        return ""
    return ", ".join(f"{part:.1f}" for part in place) if isinstance(place, tuple) else f"{place:.10g}"

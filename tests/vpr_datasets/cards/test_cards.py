"""Every card of ours, its layout and its renderer fit together: shown on a few small simulated images."""

import copy
import tomllib
from importlib.resources import files

import numpy as np
import pytest

from vpr_bench.dataset.card import DATASETS, Card, expand_groups
from vpr_bench.dataset.load import load_from
from vpr_bench.registry import import_object
from vpr_bench.types.protocol import UNMEASURED

OURS = [entry.name for entry in DATASETS.entries() if entry.target.startswith("vpr_datasets.")]
THESIS = ["amstertime", "berlin-a100", "berlin-halenseestrasse", "berlin-kudamm", "gardens", "nordland", "st-lucia"]
FEW = 14
"""Frames of each traverse; more than the five nearest, and than are within 25 metres."""


def in_small(card: Card) -> Card:
    """Return the simulated edition of a card with few and tiny images, for which no counts are known."""
    options = copy.deepcopy(card.simulation.options) | {"frames": FEW, "width": 96, "height": 64}
    options["traverses"] = [{**one, **({"frames": FEW} if "frames" in one else {})} for one in options["traverses"]]
    content = card.in_edition("simulated").model_dump()
    content["traverses"] = [{**one, "images": None} for one in content["traverses"]]
    content["simulation"] = {"renderer": card.simulation.renderer, "options": options}
    return Card.model_validate(content)


@pytest.fixture(scope="module", params=OURS)
def small(request, tmp_path_factory):
    card = in_small(DATASETS.find(request.param))
    folder = tmp_path_factory.mktemp(card.id)
    import_object(card.simulation.renderer, "The renderer")(card.simulation.options).render(folder)
    return card, folder


def test_every_protocol_loads_and_says_what_is_right(small):
    card, folder = small
    for protocol in card.listed_protocols("simulated"):
        case = load_from(card, protocol, folder)
        if protocol.unit not in ("pair", "given"):
            case.places.check(protocol)
        assert case.ground_truth.has_match.any(), protocol
        assert case.references[0].ndim == 3 and case.queries[len(case.queries) - 1].dtype == np.uint8


def test_the_same_place_has_the_same_label_in_every_traverse(small):
    card, folder = small
    case = load_from(card, card.protocol(edition="simulated"), folder)
    if case.protocol.unit in UNMEASURED or case.protocol.unit == "f":
        assert np.mean(case.ground_truth.has_match) > 0.5
    else:
        middle = [np.median(labels, axis=0) for labels in (case.places.queries, case.places.references)]
        assert np.linalg.norm(middle[0] - middle[1]) < 100  # metres: one road, and not one on another continent


def test_the_compass_is_kept_where_there_is_one(small):
    card, folder = small
    case = load_from(card, card.protocol(edition="simulated"), folder)
    assert (case.reference_compass is not None) == (card.loader.layout == "mapillary")
    if case.reference_compass is not None:
        turn = np.radians(case.reference_compass[:, None] - case.query_compass[None])
        assert np.cos(turn).mean() > 0.7  # both drive the same way


def test_the_thesis_has_seven_datasets():
    assert sorted(expand_groups(["thesis"])) == THESIS
    assert sorted(expand_groups(["berlin"])) == [name for name in THESIS if name.startswith("berlin")]


@pytest.mark.parametrize("name", THESIS)
def test_a_card_says_what_its_users_must_know(name):
    text = files("vpr_datasets.cards").joinpath(name.replace("-", "_") + ".toml").read_text("utf-8")
    card = tomllib.loads(text)
    for field in ("citation", "licence", "homepage", "summary"):
        assert card[field].strip()
    assert card.get("obtain") or card.get("download")
    assert all(one["source"] for one in card.get("published", []))

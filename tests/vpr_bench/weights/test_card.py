from pathlib import Path

import pytest
import tomli_w
from pydantic import ValidationError

from vpr_bench.errors import DataError, UsageError
from vpr_bench.weights.card import WeightsCard, find_weights_card


@pytest.mark.parametrize(
    ("changes", "fault"),
    [
        ({"url": None}, "either url or packaged"),
        ({"packaged": "package:path"}, "either url or packaged"),
        ({"sha256": f"sha256:{'0' * 64}", "sha256_prefix": "0" * 8}, "not both"),
        ({"sha256": "0" * 64}, "sha256"),
        ({"sha256_prefix": "0" * 7}, "sha256_prefix"),
        ({"sha256_prefix": "0" * 64}, "sha256_prefix"),
        ({"id": "other-dots"}, "begin with the architecture"),
        ({"file": "../tiny.pth"}, "file"),
        ({"file": ".tiny"}, "file"),
        ({"url": "file:///etc/passwd"}, "url"),
        ({"url": None, "packaged": "package"}, "packaged"),
        ({"mean": [0.5]}, "mean"),
        ({"input_size": [0, 8]}, "input_size"),
        ({"colour": "red"}, "colour"),
    ],
)
def test_a_card_that_makes_no_sense_is_refused(make_card, changes, fault):
    with pytest.raises(ValidationError, match=fault):
        make_card(**changes)


def test_a_card_is_read_from_toml(tmp_path, make_card):
    file = tmp_path / "card.toml"
    file.write_text(tomli_w.dumps(make_card(sha256_prefix="01234567").model_dump(exclude_none=True)))
    assert WeightsCard.from_toml(file) == make_card(sha256_prefix="01234567")


@pytest.mark.parametrize(
    ("text", "fault"), [("id = 1", "is not valid: id"), ("id =", "cannot be read"), (None, "cannot")]
)
def test_a_card_that_cannot_be_read_is_a_data_error(tmp_path, text, fault):
    file = tmp_path / "card.toml"
    if text is not None:
        Path(file).write_text(text)
    with pytest.raises(DataError, match=fault):
        WeightsCard.from_toml(file)


def test_weights_are_found_by_id_and_the_nearest_is_suggested(tiny_weights):
    assert find_weights_card("tiny-net-dots").training_set == "Dots"
    with pytest.raises(UsageError, match=r"no set of weights 'tiny-net-dot'\. Did you mean 'tiny-net-dots'"):
        find_weights_card("tiny-net-dot")


def test_a_plug_in_must_be_a_card_of_its_own_name(tiny_weights):
    tiny_weights.register(id="tiny-net-lines")
    with pytest.raises(UsageError, match="has the id 'tiny-net-lines'"):
        find_weights_card("tiny-net-dots")

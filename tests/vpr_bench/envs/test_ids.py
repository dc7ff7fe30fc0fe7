import subprocess
import sys

import gymnasium
import pytest

from vpr_bench.dataset.card import DATASETS
from vpr_bench.envs.ids import env_id


@pytest.mark.parametrize(
    ("dataset", "expected"),
    [
        ("gardens", "Gardens"),
        ("berlin-a100", "BerlinA100"),
        ("st-lucia", "StLucia"),
        ("my-set", "MySet"),
        ("7scenes", "7scenes"),
    ],
)
def test_the_id_of_a_dataset(dataset, expected):
    assert env_id(dataset) == f"vpr_bench/{expected}-v0"


def test_every_registered_dataset_has_one():
    for entry in DATASETS.entries():
        spec = gymnasium.spec(env_id(entry.name))
        assert spec.kwargs == {"dataset": entry.name}
        assert spec.vector_entry_point is not None


def test_the_general_one_is_told_its_dataset():
    assert gymnasium.spec("vpr_bench/Place-v0").kwargs == {}


def test_third_party_datasets_have_one_too_unless_it_is_not_clear_whose_it_is(tmp_path):
    names = ["my-set", "clear-2", "clear2", "place", "Not An Id"]
    folder = tmp_path / "thirdparty-1.0.dist-info"
    folder.mkdir()
    (folder / "METADATA").write_text("Metadata-Version: 2.1\nName: thirdparty\nVersion: 1.0\n")
    (folder / "entry_points.txt").write_text(
        "[vpr_bench.datasets]\n" + "".join(f"{name} = nowhere:card\n" for name in names)
    )
    code = (
        f"import sys; sys.path.insert(0, {str(tmp_path)!r})\n"
        "import vpr_bench, gymnasium\nprint(*[name for name in gymnasium.registry if name.startswith('vpr_bench/')])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60, check=True)
    found = done.stdout.split()
    assert "vpr_bench/MySet-v0" in found and "vpr_bench/Gardens-v0" in found
    assert not {"vpr_bench/Clear2-v0", "vpr_bench/NotAnId-v0"} & set(found)
    assert found.count("vpr_bench/Place-v0") == 1


def test_an_unknown_id_is_refused_with_the_closest():
    with pytest.raises(gymnasium.error.NameNotFound, match="Gardens"):
        gymnasium.make("vpr_bench/Garden-v0")

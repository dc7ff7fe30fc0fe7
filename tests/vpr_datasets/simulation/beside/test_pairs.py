from pathlib import Path

from vpr_datasets.simulation import SimulationSpec
from vpr_datasets.simulation.beside.pairs import write
from vpr_datasets.simulation.files import Files


def test_pairs_have_the_same_number(tmp_path: Path) -> None:
    spec = SimulationSpec.model_validate({"seed": 1, "frames": 3, "traverses": [{"name": "new"}, {"name": "old"}]})
    patterns = {"new": "new/{number:04d}.png", "old": "old/{number:04d}.jpg"}
    write(spec, tmp_path, Files(first=1, skipped=(2,), patterns=patterns))
    lines = (tmp_path / "image_pairs.csv").read_text().splitlines()
    assert lines == ["id,new,old", *(f"{n},new/{n}.png,old/{n}.jpg" for n in ("0001", "0003", "0004"))]

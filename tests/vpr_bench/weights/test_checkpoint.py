import io
import os
import pickle
import struct
import tarfile
import types
import zipfile
from typing import ClassVar

import pytest
import safetensors.torch
import torch

from vpr_bench.errors import DataError
from vpr_bench.weights.checkpoint import load_checkpoint

STATE = {"conv.weight": torch.arange(24.0).reshape(2, 3, 2, 2), "fc.bias": torch.ones(2), "bn.count": torch.tensor(3)}


class _Python2Pickler(pickle._Pickler):
    """Writes text as Python 2 does."""

    dispatch: ClassVar = dict(pickle._Pickler.dispatch)

    def save_text(self, text):
        encoded = text.encode()
        self.write(pickle.SHORT_BINSTRING + struct.pack("<B", len(encoded)) + encoded)
        self.memoize(text)

    dispatch[str] = save_text


def python2_bytes(content):
    """Save as torch 0.2 did under Python 2, with which the networks of Places365 were trained."""
    writer = types.SimpleNamespace(
        Pickler=_Python2Pickler, dump=lambda value, file, protocol: _Python2Pickler(file, protocol).dump(value)
    )
    buffer = io.BytesIO()
    torch.serialization._legacy_save(content, buffer, writer, 2)
    return buffer.getvalue()


def torch_bytes(content, **options):
    buffer = io.BytesIO()
    torch.save(content, buffer, **options)
    return buffer.getvalue()


def same(found, expected=STATE):
    return found.keys() == expected.keys() and all(torch.equal(found[key], expected[key]) for key in expected)


@pytest.mark.parametrize(
    "content",
    [
        safetensors.torch.save(STATE),
        torch_bytes(STATE),
        torch_bytes(STATE, _use_new_zipfile_serialization=False),
        torch_bytes(
            {key: torch.nn.Parameter(value) if value.is_floating_point() else value for key, value in STATE.items()}
        ),
        torch_bytes({"epoch": 3, "state_dict": STATE, "optimizer": {"state": {}}}),
        torch_bytes({"state_dict": {f"module.{key}": value for key, value in STATE.items()}}),
        torch_bytes({key.replace(".", ".module.", 1): value for key, value in STATE.items()}),
        python2_bytes(
            {
                "epoch": 90,
                "arch": "tiny",
                "best_prec1": 54.2,
                "state_dict": {f"module.{key}": value for key, value in STATE.items()},
            }
        ),
    ],
    ids=["safetensors", "zip", "legacy", "parameters", "wrapped", "parallel", "partly parallel", "python 2"],
)
def test_a_checkpoint_in_any_form_gives_the_same_tensors(tmp_path, content):
    file = tmp_path / "weights.any"
    file.write_bytes(content)
    found = load_checkpoint(file)
    assert same(found)
    assert not any(tensor.requires_grad for tensor in found.values())


class _Evil:
    def __init__(self, trace):
        self.trace = trace

    def __reduce__(self):
        return os.system, (f"touch {self.trace}",)


@pytest.mark.parametrize("zipped", [True, False])
@pytest.mark.parametrize(
    "wrap", [lambda evil: evil, lambda evil: {**STATE, "x": evil}, lambda evil: {"state_dict": [evil]}]
)
def test_pickles_with_code_are_refused_and_not_run(tmp_path, zipped, wrap):
    trace, file = tmp_path / "trace", tmp_path / "evil.pth"
    file.write_bytes(torch_bytes(wrap(_Evil(trace)), _use_new_zipfile_serialization=zipped))
    with pytest.raises(DataError, match=r"evil.pth is refused: .*system.* Nothing of it was run") as raised:
        load_checkpoint(file)
    assert not trace.exists()
    assert "add_safe_globals" not in str(raised.value) and len(str(raised.value)) < 500


def test_a_bare_pickle_with_code_is_refused_and_not_run(tmp_path):
    trace, file = tmp_path / "trace", tmp_path / "evil.pth"
    file.write_bytes(pickle.dumps(_Evil(trace)))
    with pytest.raises(DataError):
        load_checkpoint(file)
    assert not trace.exists()


@pytest.mark.parametrize("whole", [safetensors.torch.save(STATE), torch_bytes(STATE), python2_bytes(STATE)])
@pytest.mark.parametrize("kept", [0, 1, 8, 9, 40, 0.5, 0.9, 0.99])
def test_a_truncated_checkpoint_is_a_data_error(tmp_path, whole, kept):
    file = tmp_path / "short.pth"
    file.write_bytes(whole[: int(kept * len(whole)) if isinstance(kept, float) else kept])
    with pytest.raises(DataError, match=r"short.pth is (damaged|refused)"):
        load_checkpoint(file)


@pytest.mark.parametrize("seed", range(20))
def test_a_garbled_checkpoint_is_read_or_a_data_error(tmp_path, seed):
    """Bytes of the header are changed at random; whatever happens, it is nothing else."""
    generator = torch.Generator().manual_seed(seed)
    for number, whole in enumerate([safetensors.torch.save(STATE), torch_bytes(STATE), python2_bytes(STATE)]):
        content = bytearray(whole)
        for place in torch.randint(0, min(len(content), 400), (4,), generator=generator).tolist():
            content[place] = int(torch.randint(0, 256, (1,), generator=generator))
        file = tmp_path / f"{number}.pth"
        file.write_bytes(content)
        try:
            load_checkpoint(file)
        except DataError as error:
            assert str(file) in str(error)


@pytest.mark.parametrize(
    ("content", "fault"),
    [
        (b"<!DOCTYPE html><html></html>", "is a web page"),
        (torch_bytes(torch.ones(3)), "holds no tensors by name"),
        (torch_bytes({}), "holds no tensors by name"),
        (torch_bytes([torch.ones(3)]), "holds no tensors by name"),
        (torch_bytes({"weight": 1.0}), "weight is float and no dense tensor"),
        (torch_bytes({1: torch.ones(1)}), "1 is Tensor"),
        (torch_bytes({"weight": torch.ones(2, 2).to_sparse()}), "no dense tensor"),
        (torch_bytes({"weight": torch.ones(2, 2, device="meta")}), "no dense tensor"),
        (torch_bytes({"a.module.b": torch.ones(1), "a.b": torch.ones(1)}), "a.b with and without 'module'"),
    ],
)
def test_what_is_no_checkpoint_is_a_data_error(tmp_path, content, fault):
    file = tmp_path / "other.pth"
    file.write_bytes(content)
    with pytest.raises(DataError, match=fault):
        load_checkpoint(file)


def test_a_zip_bomb_is_refused_before_it_is_unpacked(tmp_path):
    plain, bomb = tmp_path / "plain.pth", tmp_path / "bomb.pth"
    plain.write_bytes(torch_bytes({"weight": torch.zeros(2_000_000)}))
    with zipfile.ZipFile(plain) as source, zipfile.ZipFile(bomb, "w", zipfile.ZIP_DEFLATED) as packed:
        for one in source.infolist():
            packed.writestr(one.filename, source.read(one))
    assert bomb.stat().st_size < 20_000
    with pytest.raises(DataError, match="is refused: it is compressed"):
        load_checkpoint(bomb)


def test_archives_of_the_oldest_torch_are_refused_without_advice_to_trust_them(tmp_path):
    file = tmp_path / "old.pth.tar"
    with tarfile.open(file, "w") as archive:
        for name in ("sys_info", "pickle", "storages", "tensors"):
            archive.addfile(tarfile.TarInfo(name))
    with pytest.raises(DataError, match=r"legacy .tar format\.\). Get it again\.$"):
        load_checkpoint(file)


def test_storage_that_is_larger_than_memory_is_a_data_error(tmp_path):
    content = torch_bytes({"weight": torch.ones(3)}, _use_new_zipfile_serialization=False)
    size = content.index(b"K\x03", content.index(b"cpuq"))  # how many numbers the storage says that it has
    file = tmp_path / "huge.pth"
    file.write_bytes(content[:size] + b"\x8a\x06" + (10**13).to_bytes(6, "little") + content[size + 2 :])
    with pytest.raises(DataError, match=r"huge.pth is damaged or no checkpoint"):
        load_checkpoint(file)


def test_a_missing_file_is_a_data_error(tmp_path):
    with pytest.raises(DataError, match=r"gone.pth: No such file"):
        load_checkpoint(tmp_path / "gone.pth")

import os
import shutil
import subprocess
import sys
import threading
from pathlib import Path

import pytest

from vpr_bench.dataset.card import Simulation
from vpr_bench.dataset.editions import choose_edition, edition_folder, find_images, search
from vpr_bench.dataset.load import load_case
from vpr_bench.errors import DataError, UsageError


def resolve(card, asked):
    edition = choose_edition(card, asked)
    return edition, edition_folder(card, edition)


def contents(folder):
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def with_simulation(card, renderer="tiny_plugin:Renderer", **options):
    return card.model_copy(update={"simulation": Simulation(renderer=renderer, options={"version": 1, **options})})


@pytest.mark.parametrize("where", ["tiny", "TinyTextures", "tiny/walks", "TinyTextures/archive/walks"])
def test_the_real_images_are_found(tiny_dataset, data_folder, where):
    moved = tiny_dataset.folder.rename(data_folder / "elsewhere")
    (data_folder / where).parent.mkdir(parents=True, exist_ok=True)
    moved.rename(data_folder / where)
    for edition in ("real", "auto"):
        assert resolve(tiny_dataset.card, edition) == ("real", data_folder / where)


def test_the_real_images_are_not_looked_for_deeper_or_elsewhere(tiny_dataset, data_folder):
    for where in ("tiny/a/b/c", "other"):
        moved = data_folder / where
        moved.parent.mkdir(parents=True, exist_ok=True)
        shutil.copytree(tiny_dataset.folder / "day_left", moved / "day_left")
    for traverse in tiny_dataset.card.traverses:
        shutil.rmtree(tiny_dataset.folder / traverse.name)
    assert find_images(tiny_dataset.card) is None


def test_the_folders_that_a_mac_adds_to_archives_are_passed_by(tiny_dataset, tmp_path):
    archive = tmp_path / "archive"
    for traverse in tiny_dataset.card.traverses:
        (archive / "__MACOSX" / "walks" / traverse.name).mkdir(parents=True)
    shutil.copytree(tiny_dataset.folder, archive / "walks")
    assert search(archive, tiny_dataset.card) == archive / "walks"


def test_an_empty_folder_is_no_dataset(tiny_dataset):
    tiny_dataset.without_images().folder.mkdir()
    assert resolve(tiny_dataset.card, "auto")[0] == "simulated"


@pytest.mark.parametrize("lost", ["day_right", "day_right/Image004.jpg"])
def test_a_partial_dataset_is_an_error_and_never_replaced_in_silence(tiny_dataset, lost):
    path = tiny_dataset.folder / lost
    shutil.rmtree(path) if path.is_dir() else path.unlink()
    assert resolve(tiny_dataset.card, "auto") == ("real", tiny_dataset.folder)
    with pytest.raises(DataError, match=r"day_right.*missing"):
        load_case("tiny")
    assert tiny_dataset.rendered == []


def test_real_images_that_are_missing_are_an_error_that_says_what_to_do(tiny_dataset, data_folder):
    with pytest.raises(DataError, match=f"not under {data_folder}.*`vpr-bench data fetch tiny`.*VPR_BENCH_DATA"):
        resolve(tiny_dataset.without_images().card, "real")
    assert tiny_dataset.rendered == []


def test_a_dataset_without_a_simulation_has_only_its_real_images(tiny_dataset):
    card = tiny_dataset.card.model_copy(update={"simulation": None})
    assert resolve(card, "auto")[0] == "real"
    with pytest.raises(UsageError, match="edition of tiny must be one of auto, real"):
        resolve(card, "simulated")
    tiny_dataset.without_images()
    with pytest.raises(DataError, match="The real images of tiny are not under"):
        resolve(card, "auto")


@pytest.mark.parametrize("edition", ["", "Real", "synthetic"])
def test_an_unknown_edition_is_refused(tiny_dataset, edition):
    with pytest.raises(UsageError, match=f"must be one of auto, real, simulated. Got '{edition}' instead"):
        resolve(tiny_dataset.card, edition)


def test_the_simulated_edition_is_rendered_once(tiny_dataset, tiny_images, tmp_path):
    first = resolve(tiny_dataset.card, "simulated")
    assert first == resolve(tiny_dataset.card, "simulated")
    assert first == resolve(tiny_dataset.without_images().card, "auto")
    name, folder = first
    assert name == "simulated" and folder == tmp_path / "cache/vpr-bench/simulated/tiny-v1"
    assert contents(folder) == contents(tiny_images)
    assert len(tiny_dataset.rendered) == 1


def test_it_is_rendered_beside_its_place_and_readable_by_others(tiny_dataset):
    _, folder = resolve(tiny_dataset.card, "simulated")
    assert tiny_dataset.rendered[0].parent == folder.parent and tiny_dataset.rendered[0] != folder
    assert folder.stat().st_mode & 0o755 == 0o755
    assert [path.name for path in folder.parent.iterdir() if path.is_dir()] == ["tiny-v1"]


def test_another_fingerprint_is_rendered_anew_and_the_former_kept(tiny_dataset):
    folders = [resolve(with_simulation(tiny_dataset.card, version=v), "simulated")[1] for v in (1, 2, 1)]
    assert folders[0] == folders[2] != folders[1]
    assert len(tiny_dataset.rendered) == 2 and all(folder.is_dir() for folder in folders)


def test_a_deleted_cache_is_rendered_again(tiny_dataset):
    _, folder = resolve(tiny_dataset.card, "simulated")
    shutil.rmtree(folder)
    assert resolve(tiny_dataset.card, "simulated")[1].is_dir()
    assert len(tiny_dataset.rendered) == 2


@pytest.mark.parametrize("error", [RuntimeError("no paint"), KeyboardInterrupt()], ids=["failed", "interrupted"])
def test_a_rendering_that_breaks_off_leaves_nothing(tiny_dataset, monkeypatch, error):
    def render(self, folder):
        (folder / "day_left").mkdir()
        raise error

    with monkeypatch.context() as broken:
        broken.setattr(sys.modules["tiny_plugin"].Renderer, "render", render)
        with pytest.raises(DataError if isinstance(error, RuntimeError) else KeyboardInterrupt):
            resolve(tiny_dataset.card, "simulated")
    cache = Path(os.environ["XDG_CACHE_HOME"]) / "vpr-bench" / "simulated"
    assert [path for path in cache.iterdir() if path.is_dir()] == []
    assert resolve(tiny_dataset.card, "simulated")[1].is_dir()


def test_what_a_killed_rendering_left_is_removed(tiny_dataset):
    cache = Path(os.environ["XDG_CACHE_HOME"]) / "vpr-bench" / "simulated"
    (cache / "tiny-v1.partial-abc" / "day_left").mkdir(parents=True)
    resolve(tiny_dataset.card, "simulated")
    assert [path.name for path in cache.iterdir() if path.is_dir()] == ["tiny-v1"]


def test_two_threads_render_once(tiny_dataset):
    start, folders = threading.Barrier(4), []

    def render():
        start.wait()
        folders.append(resolve(tiny_dataset.card, "simulated")[1])

    threads = [threading.Thread(target=render) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(folders) == 4 and len(set(folders)) == 1
    assert len(tiny_dataset.rendered) == 1


SLOW_PLUGIN = """
import time
from pathlib import Path

class Renderer:
    def __init__(self, options):
        self.log = Path(options["log"])

    def fingerprint(self):
        return "slow"

    def render(self, folder):
        with self.log.open("a") as log:
            log.write("rendered\\n")
        time.sleep(0.5)
        (folder / "day_left").mkdir()
"""
SLOW_SCRIPT = """
import sys
from vpr_bench.dataset.card import Card
from vpr_bench.dataset.editions import edition_folder
print(edition_folder(Card.model_validate_json(sys.stdin.read()), "simulated"))
"""


def test_two_processes_render_once(tiny_card, data_folder, tmp_path):
    (tmp_path / "slow_plugin.py").write_text(SLOW_PLUGIN)
    card = with_simulation(tiny_card, "slow_plugin:Renderer", log=str(tmp_path / "log"))
    environment = {**os.environ, "PYTHONPATH": str(tmp_path)}
    pipes = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE, "text": True, "env": environment}
    processes = [subprocess.Popen([sys.executable, "-c", SLOW_SCRIPT], **pipes) for _ in range(2)]
    for process in processes:
        process.stdin.write(card.model_dump_json())
        process.stdin.close()
    folders = [process.stdout.read().strip() for process in processes]
    assert [process.wait(30) for process in processes] == [0, 0]
    for process in processes:
        process.stdout.close()
    assert folders[0] == folders[1] and (Path(folders[0]) / "day_left").is_dir()
    assert (tmp_path / "log").read_text() == "rendered\n"


@pytest.mark.parametrize("blocked", ["cache", "cache/vpr-bench", "cache/vpr-bench/simulated"])
def test_a_cache_that_cannot_be_written_is_a_data_error(tiny_dataset, tmp_path, blocked):
    path = tmp_path / blocked
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("a file in place of a folder")
    with pytest.raises(DataError, match=rf"{path} is in the way") as caught:
        resolve(tiny_dataset.card, "simulated")
    assert str(caught.value).count("\n") <= 1
    assert tiny_dataset.rendered == []


def test_a_full_disk_is_a_data_error(tiny_dataset, monkeypatch):
    def render(self, folder):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(sys.modules["tiny_plugin"].Renderer, "render", render)
    with pytest.raises(DataError, match="the disk is full"):
        resolve(tiny_dataset.card, "simulated")

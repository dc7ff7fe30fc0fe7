import shutil

import pytest

from vpr_bench.dataset.acquire import fetch_images, verify_images
from vpr_bench.dataset.card import Download
from vpr_bench.dataset.known import known_digest
from vpr_bench.errors import DataError, VprBenchError


def files(folder, prefix=""):
    return {f"{prefix}{path.relative_to(folder)}": path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def from_page(card, page, sha256=None):
    return card.model_copy(update={"download": Download(url=page.url, sha256=sha256)})


def left_in(folder):
    """What is in a folder, without the locks of finished downloads."""
    return sorted(path.name for path in folder.iterdir() if path.suffix != ".lock")


@pytest.mark.parametrize("prefix", ["", "TinyTextures/", "a/b/"])
def test_an_archive_is_fetched_into_the_data_root(tiny_card, tiny_images, data_folder, server, make_zip, prefix):
    page = server.add("/tiny.zip", make_zip(files(tiny_images, prefix)))
    for _ in range(2):
        assert fetch_images(from_page(tiny_card, page, page.sha256)) == data_folder / "tiny" / prefix
    assert files(data_folder / "tiny") == files(tiny_images, prefix)
    assert left_in(data_folder) == ["tiny"]
    assert len(page.requests) == 1


def test_an_archive_without_a_digest_is_vouched_for_by_its_images(
    tiny_card, tiny_images, data_folder, server, make_tar
):
    page = server.add("/tiny.tar.gz", make_tar(files(tiny_images), "w:gz"))
    assert fetch_images(from_page(tiny_card, page)) == data_folder / "tiny"


def test_an_archive_in_the_archive_is_unpacked_in_its_place(tiny_card, tiny_images, data_folder, server, make_zip):
    page = server.add("/data.zip", make_zip({"v1/Tiny-v1.0.zip": make_zip(files(tiny_images)), "v1/notes.md": b"x"}))
    card = tiny_card.model_copy(update={"download": Download(url=page.url, inner="Tiny-v1.0.zip")})
    assert fetch_images(card) == data_folder / "tiny" / "v1" / "Tiny-v1.0"
    assert sorted(path.name for path in (data_folder / "tiny" / "v1").iterdir()) == ["Tiny-v1.0", "notes.md"]


@pytest.mark.parametrize("content", [{"other.zip": b"x"}, {"a/Tiny.zip": b"x", "b/Tiny.zip": b"x"}])
def test_an_archive_that_should_hold_another_and_does_not_is_refused(tiny_card, data_folder, server, make_zip, content):
    page = server.add("/data.zip", make_zip(content))
    with pytest.raises(DataError, match="should hold one Tiny"):
        fetch_images(tiny_card.model_copy(update={"download": Download(url=page.url, inner="Tiny.zip")}))
    assert left_in(data_folder) == []


def test_an_archive_in_the_archive_is_as_hostile_as_any(tiny_card, data_folder, server, make_zip):
    page = server.add("/data.zip", make_zip({"Tiny.zip": make_zip({"../../evil.txt": b"x"})}))
    with pytest.raises(DataError, match="evil"):
        fetch_images(tiny_card.model_copy(update={"download": Download(url=page.url, inner="Tiny.zip")}))
    assert left_in(data_folder) == [] and not list(data_folder.parent.rglob("evil.txt"))


def test_an_archive_without_a_digest_is_known_from_its_first_contact_on(
    tiny_card, tiny_images, data_folder, server, make_zip
):
    page = server.add("/tiny.zip", make_zip(files(tiny_images)))
    folder = fetch_images(from_page(tiny_card, page))
    assert known_digest(page.url) == page.sha256
    shutil.rmtree(folder)
    server.add("/tiny.zip", make_zip({**files(tiny_images), "surprise.txt": b"another archive"}))
    with pytest.raises(DataError, match="expected sha256"):
        fetch_images(from_page(tiny_card, page))
    assert not folder.exists()


def wrong_file(content):
    content["day_left/Image000.jpg"] = content["day_left/Image001.jpg"]


def lost_file(content):
    del content["night_right/Image003.jpg"]


def no_image(content):
    content["day_right/Image002.jpg"] = b"hello"


def no_traverse(content):
    content.clear()
    content["index.html"] = b"moved"


@pytest.mark.parametrize(
    ("spoil", "message"),
    [
        (wrong_file, "day_left is not the copy that the card knows"),
        (lost_file, r"Image003\.jpg is missing"),
        (no_image, r"Image002\.jpg is not an image"),
        (no_traverse, "holds none of the traverse folders of tiny"),
    ],
)
def test_wrong_contents_are_refused_and_nothing_is_left(
    tiny_card, tiny_images, data_folder, server, make_zip, spoil, message
):
    content = files(tiny_images)
    spoil(content)
    page = server.add("/tiny.zip", make_zip(content))
    with pytest.raises(DataError, match=message):
        fetch_images(from_page(tiny_card, page))
    assert left_in(data_folder) == []


def test_an_archive_of_another_digest_is_refused_and_nothing_is_left(
    tiny_card, tiny_images, data_folder, server, make_zip
):
    page = server.add("/tiny.zip", make_zip(files(tiny_images)))
    with pytest.raises(DataError, match="digest"):
        fetch_images(from_page(tiny_card, page, "sha256:" + "0" * 64))
    assert left_in(data_folder) == []


def test_a_dataset_without_a_download_says_where_to_get_it(tiny_card, data_folder):
    with pytest.raises(
        DataError, match=r"tiny cannot be downloaded automatically. Get it from https://example.org/tiny"
    ):
        fetch_images(tiny_card)


def test_what_is_there_is_not_fetched_again(tiny_dataset, data_folder):
    moved = tiny_dataset.folder.rename(data_folder / "TinyTextures")
    assert fetch_images(tiny_dataset.card) == moved


@pytest.mark.parametrize("lost", ["day_right", "day_right/Image004.jpg"])
def test_what_is_there_in_part_is_neither_taken_for_the_whole_nor_replaced(tiny_dataset, server, lost):
    path = tiny_dataset.folder / lost
    shutil.rmtree(path) if path.is_dir() else path.unlink()
    before = files(tiny_dataset.folder)
    page = server.add("/tiny.zip", b"")
    with pytest.raises(DataError, match=r"tiny is not it: .*missing[\s\S]*move it away"):
        fetch_images(from_page(tiny_dataset.card, page))
    assert files(tiny_dataset.folder) == before and page.requests == []


def test_something_else_in_its_place_is_neither_taken_for_it_nor_replaced(tiny_card, data_folder, server):
    (data_folder / "tiny").mkdir()
    (data_folder / "tiny" / "notes.txt").write_text("mine")
    page = server.add("/tiny.zip", b"")
    with pytest.raises(DataError, match=r"tiny holds none of the traverse folders of tiny.*move it away"):
        fetch_images(from_page(tiny_card, page))
    assert left_in(data_folder / "tiny") == ["notes.txt"]


def test_good_images_have_no_faults(tiny_dataset):
    assert verify_images(tiny_dataset.card, tiny_dataset.folder, "tiny") == []


def test_images_that_the_digest_vouches_for_are_not_decoded(tiny_dataset, monkeypatch):
    monkeypatch.setattr("vpr_bench.types.traverse.decode_image", lambda source: pytest.fail("decoded"))
    assert verify_images(tiny_dataset.card, tiny_dataset.folder, "tiny") == []


def change_a_byte(path):
    content = bytearray(path.read_bytes())
    content[-3] ^= 1
    path.write_bytes(content)


def truncate(path):
    path.write_bytes(path.read_bytes()[:-200])


def delete(path):
    path.unlink()


@pytest.mark.parametrize(
    ("spoil", "kind", "message"),
    [
        (
            change_a_byte,
            VprBenchError,
            "day_right is not the copy that the card knows: expected sha256",
        ),
        (truncate, DataError, r"Image005\.jpg cannot be decoded"),
        (delete, DataError, r"found 11, Image005\.jpg is missing"),
    ],
)
def test_a_fault_in_one_traverse_is_one_fault(tiny_dataset, spoil, kind, message):
    spoil(tiny_dataset.folder / "day_right" / "Image005.jpg")
    (fault,) = verify_images(tiny_dataset.card, tiny_dataset.folder, "tiny")
    assert type(fault) is kind
    with pytest.raises(VprBenchError, match=message):
        raise fault


def test_every_traverse_is_checked(tiny_dataset):
    truncate(tiny_dataset.folder / "day_left" / "Image000.jpg")
    shutil.rmtree(tiny_dataset.folder / "night_right")
    faults = verify_images(tiny_dataset.card, tiny_dataset.folder, "tiny")
    assert [name for fault in faults for name in ("day_left", "night_right") if name in str(fault)] == [
        "day_left",
        "night_right",
    ]


def test_images_without_a_known_digest_are_decoded(tiny_dataset):
    unknown = [one.model_copy(update={"digest": None}) for one in tiny_dataset.card.traverses]
    card = tiny_dataset.card.model_copy(update={"traverses": unknown})
    assert verify_images(card, tiny_dataset.folder, "tiny") == []
    truncate(tiny_dataset.folder / "day_left" / "Image000.jpg")
    assert len(verify_images(card, tiny_dataset.folder, "tiny")) == 1


def test_the_real_images_are_verified(real_gardens):
    from vpr_bench.dataset.card import find_card

    assert verify_images(find_card("gardens"), real_gardens, "gardens") == []

def test_path_of_the_root(vpr_bench, data_folder):
    assert vpr_bench("data", "path").out.strip() == str(data_folder)


def test_path_of_a_dataset(vpr_bench, tiny_dataset):
    assert vpr_bench("data", "path", "tiny").out.strip() == str(tiny_dataset.folder)


def test_path_of_what_is_not_there(vpr_bench, tiny_dataset):
    tiny_dataset.without_images()
    done = vpr_bench("data", "path", "tiny")
    assert done.code == 3
    assert "vpr-bench data fetch tiny" in done.err


def test_root_that_is_no_folder(vpr_bench, monkeypatch):
    monkeypatch.setenv("VPR_BENCH_DATA", "/no/such/folder")
    done = vpr_bench("data", "path")
    assert done.code == 3
    assert "VPR_BENCH_DATA names /no/such/folder" in done.err


def test_verify_good_images(vpr_bench, tiny_dataset):
    done = vpr_bench("data", "verify", "tiny")
    assert done.code == 0
    assert "all images" in done.out


def test_verify_another_copy(vpr_bench, tiny_dataset):
    image = tiny_dataset.folder / "day_left" / "Image001.jpg"
    image.write_bytes(image.read_bytes() + b"\0")
    done = vpr_bench("data", "verify", "tiny")
    assert done.code == 1
    assert "not the copy that the card knows" in done.err


def test_verify_damaged_images(vpr_bench, tiny_dataset):
    (tiny_dataset.folder / "day_left" / "Image001.jpg").write_bytes(b"")
    done = vpr_bench("data", "verify", "tiny")
    assert done.code == 3
    assert "Image001.jpg is empty" in done.err


def test_fetch_what_is_there_already(vpr_bench, tiny_dataset):
    done = vpr_bench("data", "fetch", "tiny")
    assert done.code == 0
    assert done.out.strip() == str(tiny_dataset.folder)


def test_fetch_what_cannot_be_downloaded(vpr_bench, tiny_dataset):
    tiny_dataset.without_images()
    done = vpr_bench("data", "fetch", "tiny")
    assert done.code == 3
    assert "https://example.org/tiny" in done.err

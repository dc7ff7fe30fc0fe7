def test_says_what_there_is(vpr_bench, tiny_dataset):
    done = vpr_bench("doctor")
    assert done.code == 0
    for fact in (
        "torch",
        "cores",
        "GiB",
        "fingerprint",
        "BLAS",
        "vpr-bench at",
        str(tiny_dataset.folder),
        "not on disk: simulated",
        "sha256:579344248",
    ):
        assert fact in done.out


def test_fault_is_shown_and_counts(vpr_bench, monkeypatch):
    monkeypatch.setenv("VPR_BENCH_DATA", "/no/such/folder")
    done = vpr_bench("doctor")
    assert done.code == 1
    assert "is not a folder" in done.out

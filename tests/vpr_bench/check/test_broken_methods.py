"""A method that does everything right passes every check; one fault more, and exactly one check fails."""

import contextlib
import json
import pickle
import socket
import threading
import time
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, ClassVar

import cv2
import numpy as np
import pytest

from vpr_bench.check import Examination
from vpr_bench.check.method import METHOD_CHECKS, Subject
from vpr_bench.types.match import Match


@dataclass
class Good:
    """Small pictures, compared pixel by pixel."""

    version: ClassVar[str] = "1"

    side: int = 8
    seed: int = 0

    def describe(self, image):
        return cv2.resize(image, (self.side, self.side), interpolation=cv2.INTER_AREA).astype(np.float32).ravel()

    def fit(self, references):
        self.database_ = np.stack([self.describe(image) for image in references])

    def scores(self, image):
        return -np.abs(self.database_ - self.describe(image)).mean(axis=1)

    def match(self, image, k):
        return Match.from_scores(self.scores(image), k)

    def match_batch(self, images, k):
        return [Good.match(self, image, k) for image in images]

    def save(self, folder):
        np.save(folder / "database.npy", self.database_)

    def load(self, folder):
        self.database_ = np.load(folder / "database.npy")
        return self


@dataclass
class GoodInOrder(Good):
    """Remembers the query before."""

    sequential: ClassVar[bool] = True

    def fit(self, references):
        super().fit(references)
        self.reset()

    def load(self, folder):
        super().load(folder).reset()
        return self

    def reset(self):
        self.before = np.zeros(1, np.float32)

    def match(self, image, k):
        scores = self.scores(image)
        mixed = scores + 0.2 * np.roll(self.before, 1)
        self.before = scores
        return Match.from_scores(mixed, k)

    def match_batch(self, images, k):
        return [self.match(image, k) for image in images]


FAULTS: list[tuple[str, type]] = []


def fails(check):
    """Note that the class below has one fault, and which check must find it."""

    def note(method):
        FAULTS.append((check, dataclass(method)))
        return FAULTS[-1][1]

    return note


@fails("declares-parameters")
class RoundsItsParameter(Good):
    side: int = 9

    def __post_init__(self):
        self.side = self.side // 2 * 2


@fails("declares-parameters")
class KeysThatAreNoText(Good):
    weights: Any = field(default_factory=lambda: {1: 0.5})


@fails("declares-parameters")
class CannotBeWritten(Good):
    scale: Any = field(default_factory=lambda: {1.5, 2.5})


@fails("answers-are-matches")
class SaysListsAreMatches(Good):
    def match(self, image, k):
        return super().match(image, k).indices.tolist()


@fails("answers-are-matches")
class NotANumber(Good):
    def match(self, image, k):
        return Match(np.arange(1), [np.nan])


@fails("answers-are-matches")
class WritesIntoItsMatch(Good):
    def match(self, image, k):
        match = super().match(image, k)
        match.indices[:] = 0
        return match


@fails("answers-are-matches")
class CountsFromOne(Good):
    def match(self, image, k):
        match = super().match(image, k)
        return Match(match.indices + 1, match.scores)


@fails("answers-are-matches")
class AnswersAll(Good):
    def match(self, image, k):
        return super().match(image, len(self.database_))


@fails("as-many-as-asked")
class AnswersOneFewer(Good):
    def match(self, image, k):
        return super().match(image, max(k - 1, 1))

    def match_batch(self, images, k):
        return [self.match(image, k) for image in images]


@fails("answers-are-matches")
class CannotFit(Good):
    def fit(self, references):
        raise RuntimeError("out of memory")


@fails("answers-are-matches")
class Exits(Good):
    def fit(self, references):
        raise SystemExit(0)


@fails("answers-are-matches")
class SequentialWithoutReset(Good):
    sequential: ClassVar[bool] = True


@fails("more-asked-than-there-are")
class Partitions(Good):
    def match(self, image, k):
        scores = self.scores(image)
        np.partition(scores, k - 1)
        return Match.from_scores(scores, k)


@fails("map-of-one")
class Standardises(Good):
    def match(self, image, k):
        scores = self.scores(image)
        if np.ptp(scores) == 0 and len(scores) == 1:
            raise ZeroDivisionError("division by zero")
        return Match.from_scores(scores, k)


@fails("grey-images")
class DividesByColourfulness(Good):
    def describe(self, image):
        if image.max() > image.min() and not np.ptp(image.astype(int), axis=2).any():
            raise ZeroDivisionError("division by zero")
        return super().describe(image)


@fails("odd-sizes")
class StacksReferences(Good):
    def fit(self, references):
        np.stack(list(references))
        super().fit(references)


@fails("odd-sizes")
class TakesWindows(Good):
    def describe(self, image):
        assert min(image.shape[:2]) >= 64
        return super().describe(image)


@fails("featureless-images")
class DividesByContrast(Good):
    def describe(self, image):
        if image.std() == 0:
            raise ZeroDivisionError("division by zero")
        return super().describe(image)


@fails("input-unmodified")
class NormalisesTheQueryInPlace(Good):
    def match(self, image, k):
        image -= image.min()
        return super().match(image, k)


@fails("input-unmodified")
class NormalisesReferencesInPlace(Good):
    def fit(self, references):
        images = list(references)
        for image in images:
            image[0] = 0
        self.database_ = np.stack([self.describe(image) for image in references])


@fails("input-unmodified")
class NeedsWritableImages(Good):
    def match(self, image, k):
        if not image.flags.writeable:
            raise ValueError("buffer source array is read-only")
        return super().match(image, k)


@fails("same-seed-same-answer")
class ForgetsItsSeed(Good):
    def fit(self, references):
        super().fit(references)
        self.database_ += np.random.default_rng().normal(size=self.database_.shape)


@fails("batch-equals-single")
class ShufflesBatches(Good):
    def match_batch(self, images, k):
        return super().match_batch(images, k)[::-1]


@fails("batch-equals-single")
class LosesOneOfABatch(Good):
    def match_batch(self, images, k):
        return super().match_batch(images, k)[:-1]


@fails("refit-forgets")
class Appends(Good):
    def fit(self, references):
        former = getattr(self, "seen", [])
        self.seen = former + [self.describe(image) for image in references]
        self.database_ = np.stack(self.seen)[-len(references) :] + len(former)


@fails("reset-forgets")
class ResetsNothing(GoodInOrder):
    def fit(self, references):
        super().fit(references)
        self.before = np.zeros(1, np.float32)

    def reset(self):
        if not hasattr(self, "before"):
            super().reset()


@fails("finds-the-same-image")
class Guesses(Good):
    def scores(self, image):
        asked = self.describe(image).sum()
        return np.sin(1000 * (self.database_.sum(axis=1) + asked))


@fails("no-leak-through-order")
class StepCounter(Good):
    """Declares nothing, counts queries, looks at none."""

    sequential: ClassVar[bool] = False

    def fit(self, references):
        super().fit(references)
        self.reset()

    def load(self, folder):
        super().load(folder).reset()
        return self

    def reset(self):
        self.step = 0

    def scores(self, image):
        place = self.step % len(self.database_)
        self.step += 1
        return -np.abs(np.arange(len(self.database_)) - place).astype(np.float32)

    def match_batch(self, images, k):
        return [self.match(image, k) for image in images]


@fails("no-leak-through-order")
class SequentialStepCounter(StepCounter):
    sequential: ClassVar[bool] = True


@fails("no-leak-through-order")
class LastPlusOne(StepCounter):
    """Looks at the first query only."""

    sequential: ClassVar[bool] = True

    def scores(self, image):
        if self.step == 0:
            self.start = int(Good.scores(self, image).argmax())
        self.step += 1
        place = (self.start + self.step - 1) % len(self.database_)
        return -np.abs(np.arange(len(self.database_)) - place).astype(np.float32)


@fails("no-leak-through-order")
class UndeclaredLastPlusOne(LastPlusOne):
    sequential: ClassVar[bool] = False


@fails("permuted-queries")
class AdaptsToQueries(Good):
    def fit(self, references):
        super().fit(references)
        self.mean = 0.0

    def load(self, folder):
        super().load(folder)
        self.mean = 0.0
        return self

    def match(self, image, k):
        self.mean = 0.9 * self.mean + 0.1 * float(image.mean())
        match = super().match(image, k)
        return Match(match.indices, match.scores - np.float32(self.mean))

    def match_batch(self, images, k):
        return [self.match(image, k) for image in images]


@fails("permuted-references")
class PrefersEarlyPlaces(Good):
    def scores(self, image):
        return super().scores(image) - 0.01 * np.arange(len(self.database_), dtype=np.float32)


@fails("save-load-round-trip")
class RoundsWhatItSaves(Good):
    def save(self, folder):
        np.save(folder / "database.npy", (self.database_ / 32).round() * 32)


@fails("save-load-round-trip")
class LoadsFromWhereItSaved(Good):
    saved: ClassVar[Path | None] = None

    def save(self, folder):
        super().save(folder)
        type(self).saved = folder

    def load(self, folder):
        return super().load(self.saved)


@fails("save-load-round-trip")
class LoadsLazily(Good):
    def load(self, folder):
        self.folder = folder
        return self

    def match(self, image, k):
        if hasattr(self, "folder"):
            super().load(self.folder)
        return super().match(image, k)


@fails("save-load-round-trip")
class LoadReturnsNothing(Good):
    def load(self, folder):
        super().load(folder)


@fails("pickles-nothing")
class Pickles(Good):
    def save(self, folder):
        (folder / "map.bin").write_bytes(pickle.dumps(self.database_))

    def load(self, folder):
        self.database_ = pickle.loads((folder / "map.bin").read_bytes())  # noqa: S301
        return self


@fails("pickles-nothing")
class SavesObjects(Good):
    def save(self, folder):
        np.savez(folder / "map.npz", facts=np.array({"side": self.side}, dtype=object), database=self.database_)

    def load(self, folder):
        with np.load(folder / "map.npz") as stored:
            self.database_ = stored["database"]
        return self


@fails("threads-respected")
class RaisesTheLimit(Good):
    def match(self, image, k):
        cv2.setNumThreads(4)
        return super().match(image, k)


@fails("threads-respected")
class StartsManyThreads(Good):
    def fit(self, references):
        threads = [threading.Thread(target=time.sleep, args=(0.03,)) for _ in range(12)]
        for thread in threads:
            thread.start()
        super().fit(references)
        for thread in threads:
            thread.join()


@fails("no-network")
class Downloads(Good):
    def fit(self, references):
        with socket.create_server(("127.0.0.1", 0)) as server:
            socket.create_connection(server.getsockname()).close()
        super().fit(references)


@fails("no-network")
class AsksForUpdates(Good):
    def match(self, image, k):
        with contextlib.suppress(OSError):
            socket.getaddrinfo("127.0.0.1", 443)
        return super().match(image, k)


@fails("leaves-no-files")
class KeepsALog(Good):
    def match(self, image, k):
        with Path("log.txt").open("a") as log:
            log.write("asked\n")
        return super().match(image, k)


@fails("leaves-no-files")
class KeepsACache(Good):
    def fit(self, references):
        Path("cache").mkdir(exist_ok=True)
        np.save("cache/map.npy", np.zeros(3))
        super().fit(references)


def results(method):
    examination = Examination(METHOD_CHECKS, Subject.of(method))
    return {check.id: examination.outcome(check.id) for check in METHOD_CHECKS}


@pytest.fixture(autouse=True)
def _cleaned_up(tmp_path, monkeypatch):
    """Some leave files where they are, and one changes OpenCV."""
    monkeypatch.chdir(tmp_path)
    threads = cv2.getNumThreads()
    yield
    cv2.setNumThreads(threads)


def test_a_good_method_passes_everything():
    found = results(Good)
    assert {name: one.reason for name, one in found.items() if one.result != "pass"} == {
        "reset-forgets": "it is not sequential"
    }


def test_a_good_sequence_method_passes_everything():
    found = results(GoodInOrder)
    assert {name: one.reason for name, one in found.items() if one.result != "pass"} == {
        "permuted-queries": "it is sequential: what came before counts",
        "permuted-references": "it is sequential: the order of the map counts",
    }


def test_who_declares_why_may_answer_fewer():
    @dataclass
    class KeepsOnlyWhatIsAlike(Good):
        may_answer_fewer: ClassVar[str] = "what is not alike is no answer"

        def match(self, image, k):
            match = Good.match(self, image, k)
            near = match.scores > match.scores[0] - 1
            return Match(match.indices[near], match.scores[near])

        def match_batch(self, images, k):
            return [self.match(image, k) for image in images]

    found = results(KeepsOnlyWhatIsAlike)
    assert "fail" not in {one.result for one in found.values()}
    assert found["as-many-as-asked"].reason == "it may answer fewer: what is not alike is no answer"


@pytest.mark.parametrize(("check", "method"), FAULTS, ids=[method.__name__ for _, method in FAULTS])
def test_a_broken_method_fails_exactly_one_check(check, method):
    found = results(method)
    assert [name for name, one in found.items() if one.result == "fail"] == [check], json.dumps(
        {name: one.reason for name, one in found.items()}, indent=1
    )
    assert found[check].reason


def test_there_is_a_broken_method_for_every_check():
    assert {check for check, _ in FAULTS} == {check.id for check in METHOD_CHECKS}

"""The card of pre-trained weights: what they are, what they were trained on, and where they come from."""

import tomllib
from importlib.resources.abc import Traversable
from typing import Annotated

from pydantic import BaseModel, ConfigDict, Field, ValidationError, model_validator

from vpr_bench.dataset.card import Digest
from vpr_bench.errors import DataError, first_fault
from vpr_bench.registry import Registry

Channels = tuple[float, float, float]
Side = Annotated[int, Field(gt=0)]


class WeightsCard(BaseModel):
    """Everything the harness knows about weights; read from TOML, unknown fields refused.

    They are either downloaded or ``packaged``: part of an installed package, where a function says.
    """

    model_config = ConfigDict(frozen=True, extra="forbid")

    id: str = Field(pattern=r"^[a-z0-9][a-z0-9-]*$", description="architecture-set: resnet18-places365")
    name: str
    architecture: str = Field(pattern=r"^[a-z0-9][a-z0-9-]*$", description="the id begins with it")
    training_set: str
    input_size: tuple[Side, Side] = Field(description="width and height that they were trained at, in pixels")
    mean: Channels = Field(description="of RGB in [0, 1]; what is subtracted")
    std: Channels = Field(description="of RGB in [0, 1]; what is divided by")
    licence: str
    homepage: str
    file: str = Field(pattern=r"^\w[\w.-]*$", description="the file's name")
    url: str | None = Field(None, pattern=r"^https?://")
    packaged: str | None = Field(None, pattern=r"^[\w.]+:[\w.]+$", description="module:function that returns the path")
    obtain: str = Field("", description="how to get them where they cannot be fetched")
    sha256: Digest | None = None
    sha256_prefix: str | None = Field(
        None, pattern=r"^[0-9a-f]{8,63}$", description="where only the first digits are published"
    )

    @model_validator(mode="after")
    def _hangs_together(self) -> "WeightsCard":
        if (self.url is None) == (self.packaged is None):
            raise ValueError("give either url or packaged")
        if self.sha256 is not None and self.sha256_prefix is not None:
            raise ValueError("give sha256 or sha256_prefix, not both")
        if not self.id.startswith(f"{self.architecture}-"):
            raise ValueError(f"the id must begin with the architecture, {self.architecture}-")
        return self

    @classmethod
    def from_toml(cls, file: Traversable) -> "WeightsCard":
        """Read a card.

        Raises
        ------
        DataError
            If it is not TOML or does not describe weights; names the first field that is wrong.
        """
        try:
            return cls.model_validate(tomllib.loads(file.read_text("utf-8")))
        except ValidationError as error:
            raise DataError(f"The card {file} is not valid: {first_fault(error)}.") from None
        except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
            raise DataError(f"The card {file} cannot be read: {error}.") from None


WEIGHTS: Registry[WeightsCard] = Registry("vpr_bench.weights", "set of weights", WeightsCard)


def find_weights_card(name: str) -> WeightsCard:
    """Return the card of weights by their id.

    Raises
    ------
    UsageError
        If there are none of that id; the closest one is suggested.
    """
    return WEIGHTS.find(name)

"""The planners and their settings as data."""

from __future__ import annotations

from dataclasses import dataclass
from numbers import Real
from typing import Any, Union

from . import _core

Value = Union[str, bool, int, float]


@dataclass(frozen=True)
class Setting:
    """One option of a planner."""

    name: str
    meaning: str
    value: Value  #: now
    default: Value
    low: float  #: the range, both ends included; of a word its index
    high: float
    unit: str  #: empty for counts, shares, switches and words
    words: tuple[str, ...]  #: those it may be; empty for numbers and switches
    range: str  #: what it may be, in words
    why: str  #: why the default is what it is
    source: str  #: who proposed what it sets


def _text(value: Any) -> str:
    if isinstance(value, str):
        return value
    if isinstance(value, bool):
        return "on" if value else "off"
    if isinstance(value, Real):
        return repr(int(value)) if float(value).is_integer() else repr(float(value))
    if type(value).__name__ == "bool_":  # numpy's
        return "on" if value else "off"
    raise TypeError(f"a setting is a number, a bool or a word, not {value!r}")


class Planner:
    """A planner by its name, and its settings.

    Settings are given by name, "_" standing for "-":

    >>> import asv
    >>> planner = asv.Planner("rrt-star", goal_bias=0.2)
    >>> planner["nodes"] = 2000
    >>> planner["goal-bias"], planner["nodes"]
    (0.2, 2000)

    Raises ValueError, which says what there is, for an unknown name or a value out of range.
    """

    def __init__(self, name: str = "auto", **settings: Value) -> None:
        self._choice = _core.PlannerChoice(name)
        for setting, value in settings.items():
            self[setting] = value

    @property
    def name(self) -> str:
        """Its name in the catalogue, see planner_names()."""
        return self._choice.name

    @property
    def summary(self) -> str:
        """What it does, in a line."""
        return self._choice.summary

    @property
    def source(self) -> str:
        """Who described it."""
        return self._choice.source

    @property
    def settings(self) -> dict[str, Setting]:
        """All that can be set, by name, with the values they have now."""
        described = (Setting(**one) for one in self._choice.describe_settings())
        return {setting.name: setting for setting in described}

    def __getitem__(self, setting: str) -> Value:
        name = setting.replace("_", "-")
        settings = self.settings
        if name not in settings:
            raise KeyError(f"planner {self.name} has no setting {setting!r}")
        return settings[name].value

    def __setitem__(self, setting: str, value: Value) -> None:
        self._choice.set(setting.replace("_", "-"), _text(value))

    def __repr__(self) -> str:
        changed = [f", {s.name.replace('-', '_')}={s.value!r}" for s in self.settings.values()
                   if s.value != s.default]
        return f"asv.Planner({self.name!r}{''.join(changed)})"


def planner_names() -> list[str]:
    """The names of all planners, the default first."""
    return list(_core.planner_names())


def planners() -> list[Planner]:
    """All planners with their default settings."""
    return [Planner(name) for name in planner_names()]


def as_planner(planner: Union[str, Planner]) -> Planner:
    """The planner, or the one of that name."""
    return planner if isinstance(planner, Planner) else Planner(planner)

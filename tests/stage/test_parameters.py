"""Parameters: one door for every value, whoever brings it."""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.stage import Choice, Param, ParameterError, Scene, Toggle


class Owner:
    """Stands for a scene class."""

    size = Param(2, 0.5, 100, unit="m")
    count = Param(5, 1, 10, whole=True)
    rate = Param(10.0, 1e-3, 1e3, log=True)
    method = Choice("semi-implicit", ("explicit", "semi-implicit"))
    on = Toggle(True)

    def __init__(self):
        self.values = {}


class TestParam:
    @pytest.mark.parametrize(
        "value", [2, 2.0, np.float32(2.0), np.int64(2), np.float64(2.0), Fraction(2), np.uint8(2)]
    )
    def test_any_kind_of_number_becomes_a_float(self, value) -> None:
        assert Owner.size.check(value) == 2.0
        assert type(Owner.size.check(value)) is float

    def test_defaults_too(self) -> None:
        assert type(Owner.size.default) is float
        assert type(Owner.count.default) is int

    @pytest.mark.parametrize("value", [5, 5.0, np.float32(5.0)])
    def test_whole_numbers_become_integers(self, value) -> None:
        assert type(Owner.count.check(value)) is int

    def test_no_negative_zero(self) -> None:
        class Other:
            zero = Param(0.0, -1.0, 1.0)

        assert math.copysign(1.0, Other.zero.check(-0.0)) == 1.0

    @pytest.mark.parametrize(
        ("value", "message"),
        [
            (math.nan, "size = nan: expected a finite number"),
            (math.inf, "expected a finite number"),
            (-math.inf, "expected a finite number"),
            (0.4999, "size = 0.4999: outside 0.5 to 100 m"),
            (100.0000001, "outside 0.5 to 100 m"),
            (1e300, "outside"),
            (10**400, "too large"),
            ("2", "expected a number"),
            (True, "expected a number"),
            (None, "expected a number"),
            ([2.0], "expected a number"),
            (2j, "expected a number"),
            (np.array([1.0, 2.0]), "expected a number"),
        ],
    )
    def test_what_is_refused(self, value, message) -> None:
        with pytest.raises(ParameterError) as caught:
            Owner.size.check(value)
        assert message in str(caught.value)

    def test_fractions_are_no_counts(self) -> None:
        with pytest.raises(ParameterError, match="whole number"):
            Owner.count.check(2.5)

    @given(st.floats() | st.integers() | st.text() | st.none() | st.booleans() | st.binary())
    def test_it_accepts_or_refuses_and_nothing_else(self, value) -> None:
        try:
            checked = Owner.size.check(value)
        except ParameterError as error:
            assert str(error).startswith("size = ")
        else:
            assert 0.5 <= checked <= 100.0

    @given(st.text(max_size=12) | st.floats().map(repr) | st.integers().map(str))
    def test_parsing_accepts_or_refuses(self, text: str) -> None:
        try:
            checked = Owner.size.parse(text)
        except ParameterError:
            return
        assert 0.5 <= checked <= 100.0

    @pytest.mark.parametrize(
        ("text", "value"), [(" 2.5 ", 2.5), ("2,5", 2.5), ("1e1", 10.0), ("+3", 3.0), ("\u202f50", 50.0)]
    )
    def test_parsing(self, text: str, value: float) -> None:
        assert Owner.size.parse(text) == value

    def test_a_true_minus(self) -> None:
        with pytest.raises(ParameterError, match=r"size = -1\.0: outside"):
            Owner.size.parse("\u22121")

    @pytest.mark.parametrize(
        "arguments",
        [(1.0, 2.0, 1.0), (1.0, 1.0, 1.0), (1.0, -math.inf, 2.0), (1.0, 0.0, math.inf), (1.0, math.nan, 2.0)],
    )
    def test_a_range_must_be_one(self, arguments) -> None:
        with pytest.raises(ValueError, match="Param"):
            Param(*arguments)

    def test_a_logarithmic_range_is_above_zero(self) -> None:
        with pytest.raises(ValueError, match="logarithmic"):
            Param(1.0, 0.0, 2.0, log=True)


class TestOthers:
    def test_choice(self) -> None:
        assert Owner.method.check("explicit") == "explicit"
        assert Owner.method.parse(" explicit\n") == "explicit"
        assert Owner.method.labels == ("Explicit", "Semi-implicit")
        for value in ("Explicit", 1, None, ["explicit"], np.array(["explicit", "explicit"])):
            with pytest.raises(ParameterError, match="expected one of explicit, semi-implicit"):
                Owner.method.check(value)

    def test_a_label_for_each_option(self) -> None:
        with pytest.raises(ValueError, match="as many labels"):
            Choice("a", ("a", "b"), labels=("A",))

    def test_an_option_is_taken_by_the_name_that_it_had_formerly(self) -> None:
        class Other:
            name = "other"
            fit = Choice("fine", ("fine", "least-area"), formerly={"calipers": "least-area"})

            def __init__(self):
                self.values = {}

        assert Other.fit.check("calipers") == Other.fit.parse(" calipers ") == "least-area"
        owner = Other()
        owner.fit = "calipers"
        assert owner.fit == "least-area"
        with pytest.raises(ParameterError, match="expected one of fine, least-area"):
            Other.fit.check("caliper")
        assert Choice("old", ("new",), formerly={"old": "new"}).formerly == {"old": "new"}

    @pytest.mark.parametrize("formerly", [{"fine": "rough"}, {"old": "gone"}])
    def test_a_former_name_is_none_of_the_options_and_stands_for_one(self, formerly) -> None:
        with pytest.raises(ValueError, match="Choice: formerly"):
            Choice("fine", ("fine", "rough"), formerly=formerly)

    def test_toggle(self) -> None:
        assert Owner.on.check(False) is False
        assert [Owner.on.parse(text) for text in ("on", "YES", "1", "false", "Off")] == [True] * 3 + [
            False
        ] * 2
        for value in (1, 0.0, "on", None):
            with pytest.raises(ParameterError, match="true or false"):
                Owner.on.check(value)
        with pytest.raises(ParameterError, match="true or false"):
            Owner.on.parse("maybe")

    def test_setting_goes_by_the_same_door(self) -> None:
        owner = Owner()
        owner.size = 3
        assert owner.values == {"size": 3.0}
        assert owner.size == 3.0
        with pytest.raises(ParameterError):
            owner.size = math.nan
        assert owner.size == 3.0

    def test_order_and_inheritance(self) -> None:
        class Base(Scene):
            first = Toggle(True)
            second = Toggle(True)

        class Derived(Base):
            third = Toggle(True)
            first = Param(1.0, 0.0, 2.0)

        assert list(Derived.declared_parameters()) == ["first", "second", "third"]
        assert isinstance(Derived.declared_parameters()["first"], Param)

    @pytest.mark.parametrize("name", ["dt", "state", "name", "values", "seed", "previous"])
    def test_a_name_that_every_scene_has_is_refused(self, name: str) -> None:
        with pytest.raises(TypeError, match="cannot have this name"):
            type("Bad", (Scene,), {name: Toggle(True)})

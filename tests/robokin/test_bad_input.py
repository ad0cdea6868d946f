"""Bad input: what each public function does with it, for every row in `arguments/`."""

import inspect
import itertools
import random
from collections import UserList, deque
from fractions import Fraction
from functools import reduce
from pkgutil import iter_modules

import arguments
import hypothesis.extra.numpy as hnp
import hypothesis.strategies as st
import numpy as np
import pytest
from arguments import (
    DATA,
    MODULES,
    PARAMETERS,
    STEPS,
    TABLE,
    bind,
    public_functions,
    rows,
)
from hypothesis import HealthCheck, given, settings

from robokin.bicycle import lane_width
from robokin.errors import RobokinError
from robokin.frames import compose
from robokin.motion import wrap_angle

METHODS = ("exact", "midpoint", "start", "end")


def call(label, **changed):
    """Call the function of a row with its working arguments, some of them changed."""
    function, positional, named = bind(label, **changed)
    return function(*positional, **named)


def results(label, **changed):
    """The results as a list of arrays, however many there are."""
    result = call(label, **changed)
    return [np.asarray(a) for a in (result if isinstance(result, tuple) else (result,))]


def batch(entry, n, parameters=False):
    """The working arguments, n times (or n × m times) over; parameters too where they broadcast."""
    shape = n if isinstance(n, tuple) else (n,)
    kinds = DATA + (PARAMETERS if parameters and entry.batches else ())
    return {
        key: np.array(np.broadcast_to(entry.args[key].good, (*shape, *entry.args[key].core)))
        for key in entry.having(*kinds)
    }


def each(*kinds, wanted=lambda entry: True):
    """Every (row, argument) of these kinds, as parameters of a test."""
    pairs = [
        (label, key)
        for label, entry in TABLE.items()
        for key in entry.having(*kinds)
        if wanted(entry)
    ]
    return pytest.mark.parametrize(("label", "key"), pairs, ids=[" ".join(pair) for pair in pairs])


def each_argument():
    return each(*{arg.kind for entry in TABLE.values() for arg in entry.args.values()})


def each_row(wanted=lambda entry: True):
    labels = [label for label, entry in TABLE.items() if wanted(entry)]
    return pytest.mark.parametrize("label", labels)


def assert_refused(label, key=None, **changed):
    """A RobokinError with a short message that names the argument."""
    with pytest.raises(RobokinError) as error:
        call(label, **changed)
    message = str(error.value)
    assert 10 < len(message) < 400, (
        f"a message of {len(message)} characters, allowed 11 to 399: say what was got, what is "
        f"allowed and what to do: {message}"
    )
    # transforms without names are numbered; a graph names poses and frames by the frames
    if key is not None and not TABLE[label].positional and not TABLE[label].on:
        assert key in message, f"the message does not name the argument {key}: {message}"
    return message


def has_answer(entry):
    return bool(entry.results and entry.having(*DATA))


# What works


@pytest.mark.parametrize("module", MODULES)
def test_each_function_has_a_row(module):
    place = f"ROWS of tests/robokin/arguments/{module}.py"
    functions, named = set(public_functions(module)), {name.split()[0] for name in rows(module)}
    missing = [f'"{name}": row(…)' for name in sorted(functions - named)]
    assert not missing, f"add {', '.join(missing)} to {place}; the files beside it are examples"
    gone = sorted(named - functions)
    assert not gone, f"robokin.{module} has no {', '.join(gone)} (any more): take it out of {place}"


def test_each_file_of_rows_has_its_module():
    gone = {module.name for module in iter_modules(arguments.__path__)} - set(MODULES)
    assert not gone, f"tests/robokin/arguments has files of no module: remove {sorted(gone)}"


@each_row(lambda entry: entry.results)
def test_one_item_in_one_item_out(label):
    assert [a.shape for a in results(label)] == TABLE[label].results
    assert all(np.isfinite(a).all() for a in results(label))


@each_row(lambda entry: entry.results)
def test_a_batch_in_a_batch_out(label):
    entry = TABLE[label]
    one = results(label)
    for parameters in (False, True):
        for n in (1, 4):
            many = batch(entry, n, parameters)
            if many:
                for a, b in zip(results(label, **many), one, strict=True):
                    # NumPy's vector sines may differ from its single ones in the last digit
                    np.testing.assert_allclose(a, np.broadcast_to(b, (n, *b.shape)), atol=1e-14)


@each_row(has_answer)
def test_an_empty_batch_gives_an_empty_result(label):
    entry = TABLE[label]
    for empty in ((0,), (3, 0), (0, 2)):
        wanted = [(*empty, *shape) for shape in entry.results]
        assert [a.shape for a in results(label, **batch(entry, empty))] == wanted
        for key in entry.having(*DATA):  # or one argument empty, the others single
            assert [a.shape for a in results(label, **{key: batch(entry, empty)[key]})] == wanted


@each(*DATA, *PARAMETERS, wanted=lambda entry: entry.results)
def test_one_argument_in_a_batch_is_enough(label, key):
    entry = TABLE[label]
    if key in batch(entry, 1, parameters=True):
        many = batch(entry, (2, 3), parameters=True)[key]
        for a, b in zip(results(label, **{key: many}), results(label), strict=True):
            np.testing.assert_allclose(a, np.broadcast_to(b, (2, 3, *b.shape)), atol=1e-14)


@each_row(lambda entry: entry.results is not None)
def test_lists_tuples_and_arrays_are_the_same_and_stay_as_they_are(label):
    entry = TABLE[label]
    keys = entry.having(*DATA, *PARAMETERS)
    wanted = results(label)
    arrays = {key: np.array(entry.args[key].good) for key in keys}
    for array in arrays.values():
        array.flags.writeable = False  # nothing may write into what it was given
    tuples = {key: totuple(entry.args[key].good) for key in keys}
    columns = {key: np.array(array, order="F") for key, array in arrays.items()}
    for changed in (arrays, tuples, columns):
        for a, b in zip(results(label, **changed), wanted, strict=True):
            np.testing.assert_array_equal(a, b)


MASKED = np.ma.masked_array([0.1, 0.2, 99], mask=[False, False, True])


@pytest.mark.parametrize(
    "value",
    [
        *(MASKED, [MASKED, MASKED], deque([MASKED]), UserList([(1, 2, 3), MASKED])),
        *([0.1, np.ma.masked, 0.2], MASKED[:2], MASKED.astype(complex)),
    ],
    ids=[
        *("an array", "in a list", "in a queue", "in a list of one's own"),
        *("a masked number", "nothing masked", "complex"),
    ],
)
def test_what_is_masked_is_refused_with_the_remedy(value):
    for function in (wrap_angle, lambda track: lane_width(0.1, 2.0, track)):
        with pytest.raises(RobokinError, match=r"must not be masked; \.filled\(np\.nan\)"):
            function(value)


def totuple(value):
    return tuple(map(totuple, value)) if isinstance(value, list) else value


@each_row(has_answer)
def test_the_result_is_one_s_own(label):
    given = batch(TABLE[label], 3)
    kept = {key: array.copy() for key, array in given.items()}
    first = call(label, **given)
    for array in first if isinstance(first, tuple) else (first,):
        if isinstance(array, np.ndarray) and array.dtype == float:
            array[...] = 7.0  # can be written into, and is no view of an argument
    for key, array in given.items():
        np.testing.assert_array_equal(array, kept[key])


# What is refused: shapes


def wrong_shapes(arg):
    *outer, last = arg.core
    yield 1.0
    yield np.ones((*outer, last + 1))
    yield np.ones((5, *outer, last + 1))
    if last > 1:
        yield np.ones((*outer, last - 1))
    if outer:
        yield np.ones(last)


@each("data", "matrix")
def test_a_wrong_shape_is_refused(label, key):
    if TABLE[label].args[key].core:
        for value in wrong_shapes(TABLE[label].args[key]):
            assert_refused(label, key, **{key: value})


@each("length", "number")
def test_a_wrong_shape_of_a_parameter_is_refused(label, key):
    arg = TABLE[label].args[key]
    if arg.core and label != "wheels.omni_robot":  # which takes any number of angles
        assert_refused(label, **{key: np.ones(arg.core[-1] + 1)})


@each_row()
def test_batches_of_different_lengths_are_refused(label):
    entry = TABLE[label]
    two, three = batch(entry, 2, parameters=True), batch(entry, 3, parameters=True)
    for key in two:
        for other in three:
            if other != key:
                assert_refused(label, **{key: two[key], other: three[other]})


@each_row(lambda entry: entry.having(*STEPS))
def test_paths_of_different_lengths_are_refused(label):
    entry = TABLE[label]
    keys = [key for key in entry.args if entry.args[key].core[-1:] == (4,)]
    for key in keys:
        for other in keys:
            if other != key:
                assert_refused(label, **{key: entry.args[other].good[:3]})


# What is refused: types


class Strange:
    """An object that fails at everything."""

    def __array__(self, *args, **kwargs):
        raise KeyError("no array")

    def __repr__(self):
        raise KeyError("no repr")


ITSELF = []
ITSELF.append(ITSELF)

NOT_NUMBERS = {
    "a string": "abc",
    "a number in a string": "1.0",
    "bytes": b"1.0",
    "strings": ["1", "2", "3"],
    "an object": object(),
    "objects": np.array([object()] * 3),
    "floats as objects": np.array([1.0, 2.0, 3.0], dtype=object),
    "a fraction": Fraction(1, 2),
    "a dict": {},
    "a filled dict": {"x": 1.0, "y": 2.0},
    "a set": {1.0, 2.0, 3.0},
    "a function": max,
    "a generator": (x for x in [1.0, 2.0, 3.0]),
    "Ellipsis": ...,
    "complex": 1j,
    "real complex": 1.0 + 0j,
    "complex numbers": [1j, 2.0, 3.0],
    "ragged": [[1.0], [1.0, 2.0]],
    "ragged at depth": [1.0, [2.0, 3.0], 4.0],
    "None inside": [1.0, None, 3.0],
    "a bool": True,
    "bools": [True, False, True],
    "NumPy's bool": np.bool_(True),
    "an int past 64 bits": 10**30,
    "ints past any float": [10**400, 1.0, 2.0],
    "dates": np.array(["2020-01-01"] * 3, dtype="datetime64[D]"),
    "durations": np.array([1, 2, 3], dtype="timedelta64[s]"),
    "a record": np.zeros(3, dtype=[("x", float), ("y", float)]),
    "a list of itself": ITSELF,
    "100 axes": reduce(lambda inner, _: [inner], range(100), 1.0),
    "60 axes": np.ones((1,) * 60),
}
NOT_PRINTABLE = {
    "an int too long to print": 10**5000,
    "a strange object": Strange(),
    "strange objects": [Strange(), Strange(), Strange()],
}


@each_argument()
def test_what_is_not_numbers_is_refused(label, key):
    for value in [*NOT_NUMBERS.values(), *NOT_PRINTABLE.values()]:
        if TABLE[label].args[key].kind != "frame" or not isinstance(value, str):
            assert_refused(label, key, **{key: value})


@each_argument()
def test_none_is_refused_but_where_it_is_the_default(label, key):
    parameters = inspect.signature(bind(label)[0]).parameters
    if key not in parameters or parameters[key].default is not None:
        assert_refused(label, key, **{key: None})


@each("name")
def test_an_unknown_name_is_refused(label, key):
    for value in ["", "no such", "EXACT", "Raise", "xyzx", "xxy", "XyZ", "xyé", 3, ["nan"]]:
        message = assert_refused(label, key, **{key: value})
        if key != "seq":
            assert TABLE[label].args[key].good in message  # says what is allowed


@each("frame")
def test_an_unknown_or_impossible_frame_is_refused(label, key):
    for value in ["", "no such", 3, ["b"]]:
        if not (label.endswith("add") and value == "no such"):
            assert_refused(label, key, **{key: value})


def test_a_chain_of_no_frames_is_refused():
    with pytest.raises(RobokinError, match="at least one"):
        compose()


@each("wheels")
def test_what_is_not_wheels_is_refused(label, key):
    for value in (1.0, "wheels", [1.0], [None], {}, np.ones(3), [TABLE[label].args[key].good]):
        assert_refused(label, key, **{key: value})


# What is refused: values of parameters

NEVER = {
    "length": [0, 0.0, -0.0, -1, -1e-300, np.nan, np.inf, -np.inf],
    "not negative": [-1, -1e-300, np.nan, np.inf, -np.inf],
    "number": [np.nan, np.inf, -np.inf],
    "bits": [0, -1, 1.5, 64, np.nan, np.inf, -np.inf],
    "modulus": [0, 1, -300, 300.5, 2.0**53, np.nan, np.inf, -np.inf],
}


@each(*PARAMETERS)
def test_a_parameter_that_cannot_be_meant_is_refused(label, key):
    arg = TABLE[label].args[key]
    for value in NEVER[arg.kind]:
        bad = np.array(arg.good, dtype=float)
        bad[(-1,) * bad.ndim] = value
        assert_refused(label, key, **{key: bad})
        assert_refused(label, key, **{key: bad.tolist()})


@each(*PARAMETERS)
def test_one_bad_element_of_a_parameter_is_refused(label, key):
    arg = TABLE[label].args[key]
    if TABLE[label].batches:
        for value in NEVER[arg.kind]:
            bad = np.array(np.broadcast_to(arg.good, (3, *arg.core)), dtype=float)
            bad[(1,) * bad.ndim] = value
            message = assert_refused(label, key, **{key: bad})
            assert "at index 1" in message  # and says which


@each("ticks", "tick steps")
def test_ticks_are_whole_numbers(label, key):
    arg = TABLE[label].args[key]
    for value in (0.5, 1e-9, 3.0000001):
        bad = np.array(arg.good, dtype=float)
        bad[(-1,) * bad.ndim] = value
        assert_refused(label, key, **{key: bad})


# NaN, infinity and huge numbers in the data


def moved(arg, index):
    """The working value with one of its numbers a little larger."""
    value = np.array(arg.good, dtype=float)
    value[index] += 1.0 if arg.kind in ("ticks", "tick steps") else 0.01
    return value


def assert_lost(result, clean, depends, value):
    """What depends on a NaN is NaN, on an infinity not finite; the rest is NaN or as it was."""
    if result.dtype == bool:
        assert not result[depends].any()
    else:
        kept = (result == clean) & ~depends
        assert (kept | (np.isnan(result) if np.isnan(value) else ~np.isfinite(result))).all()


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
@each("data", "ticks", wanted=has_answer)
def test_a_bad_value_goes_into_what_depends_on_it_and_touches_no_other_row(label, key, value):
    entry = TABLE[label]
    clean, one = batch(entry, 5), results(label)
    wanted = results(label, **clean)
    for index in np.ndindex(entry.args[key].core):
        after = results(label, **{key: moved(entry.args[key], index)})
        spoilt = clean[key].astype(float)
        spoilt[(2, *index)] = value
        single = results(label, **{key: spoilt[1:4]})  # and where it is the only batch
        for many, good, few, b, c in zip(
            results(label, **{**clean, key: spoilt}), wanted, single, one, after, strict=True
        ):
            np.testing.assert_array_equal(np.delete(many, 2, 0), np.delete(good, 2, 0))
            assert np.isfinite(few[[0, 2]]).all()
            if np.isnan(value) or key not in entry.limit_at_infinity:
                assert_lost(many[2], good[2], b != c, value)
                assert_lost(few[1], b, b != c, value)


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
@each("matrix", wanted=has_answer)
def test_a_matrix_with_a_bad_value_is_not_judged_and_gives_nan(label, key, value):
    entry = TABLE[label]
    clean = batch(entry, 5)
    wanted = results(label, **clean)
    for index in np.ndindex(entry.args[key].core):
        spoilt = clean[key].astype(float)
        spoilt[(2, *index)] = value
        spoilt[3] = np.nan
        for a, b in zip(results(label, **{**clean, key: spoilt}), wanted, strict=True):
            np.testing.assert_array_equal(a[[0, 1, 4]], b[[0, 1, 4]])
            lost = a[2:4, :3, :3] if label == "frames.se3" else a[2:4]  # the position is given
            assert np.isnan(lost).all() if a.dtype == float else not lost.any()


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
@each("steps", "tick steps")
def test_a_bad_step_goes_into_the_path_from_there_on(label, key, value):
    entry = TABLE[label]
    clean = batch(entry, 3)
    methods = [{"method": method} for method in METHODS] if "method" in entry.args else [{}]
    for k, method in itertools.product(range(entry.args[key].core[0]), methods):
        spoilt = clean[key].astype(float)
        spoilt[1, k] = value
        wanted, one = results(label, **clean, **method), results(label, **method)
        after = results(label, **{key: moved(entry.args[key], k)}, **method)
        for a, good, b, c in zip(
            results(label, **{**clean, key: spoilt}, **method), wanted, one, after, strict=True
        ):
            np.testing.assert_array_equal(a[[0, 2]], good[[0, 2]])
            later = np.zeros(a.shape[1], dtype=bool)
            later[slice(max(k - 1, 0), k + 1) if entry.nan_beside else slice(k + 1, None)] = True
            np.testing.assert_array_equal(a[1, ~later], good[1, ~later])
            assert_lost(a[1], good[1], b != c, value)
            assert not np.isfinite(a[1, later]).all(axis=tuple(range(1, a.ndim - 1))).any()


@pytest.mark.parametrize("value", [np.inf, -np.inf])
@pytest.mark.parametrize(
    ("label", "key"), [("elbow_arm.inverse", "p"), ("planar_arm.inverse", "pose")]
)
def test_an_infinite_target_is_nan_and_no_error(label, key, value):
    target = np.array(TABLE[label].args[key].good)
    for i in range(3):
        bad = np.array([target, target])
        bad[1, i] = value
        out = call(label, **{key: bad, "unreachable": "raise"})
        assert np.isfinite(out[0]).all()
        assert np.isnan(out[1]).any()


EXTREMES = [1e308, -1e308, 1e200, 5e-324, -5e-324, 1e-200, 0.0]


@each("data", "steps", wanted=lambda entry: not entry.bounded)
def test_the_largest_and_the_smallest_numbers_touch_no_other_row(label, key):
    entry = TABLE[label]
    clean = batch(entry, 3)
    wanted = results(label, **clean)
    for value in EXTREMES:
        extreme = clean[key].astype(float)
        extreme[1] = value
        for a, b in zip(results(label, **{**clean, key: extreme}), wanted, strict=True):
            np.testing.assert_array_equal(a[[0, 2]], b[[0, 2]])


@each("matrix")
def test_one_matrix_that_is_no_rotation_is_refused(label, key):
    for value in EXTREMES:
        matrices = batch(TABLE[label], 3)[key]
        matrices[1] = value
        message = assert_refused(label, key, **{key: matrices})
        assert "at index 1" in message


@each_row(lambda entry: not entry.bounded)
def test_the_largest_and_the_smallest_numbers_everywhere(label):
    # in all the data at once, and with each parameter: a warning would be an error here
    entry = TABLE[label]
    for value in EXTREMES:
        everywhere = {
            key: np.full(entry.args[key].core, value) for key in entry.having("data", "steps")
        }
        call(label, **everywhere)
        if value > 0:
            for key in entry.having("length", "number", "not negative"):
                call(label, **{key: np.full(entry.args[key].core, value)})
                call(label, **everywhere, **{key: np.full(entry.args[key].core, value)})


# Junk

CASES = 40  # of several arguments at once, for each example
SPECIAL = [0.0, -0.0, 1.0, -1.0, 0.5, 3.0, np.pi, -np.pi, np.pi / 2, 1e-16, -1e-8, 5e-324, 1e154]
SPECIAL += [1e308, -1e308, np.nan, np.inf, -np.inf]
WORDS = [
    "",
    "xyz",
    "ZYZ",
    "XYX",
    "xzy",
    "XXY",
    "xYz",
    "zyxz",
    "exact",
    "end",
    "nan",
    "raise",
    "Nan",
]

scalars = (
    st.sampled_from([None, True, 1j, ..., b"", "", {}, (), 10**400, -(2**64), Fraction(1, 3)])
    | st.sampled_from(SPECIAL)
    | st.floats(width=64)
    | st.integers(-5, 300)
    | st.integers()
    | st.text(max_size=4)
    | st.sampled_from(WORDS)
    | st.sampled_from(sorted(NOT_NUMBERS)).map(lambda what: NOT_NUMBERS[what])
)
nested = st.recursive(scalars, lambda inner: st.lists(inner, max_size=4), max_leaves=8)
any_array = hnp.arrays(
    hnp.scalar_dtypes() | hnp.unicode_string_dtypes(max_len=3),
    hnp.array_shapes(min_dims=0, max_dims=4, min_side=0, max_side=4),
)
junk = scalars | nested | any_array | st.dictionaries(st.text(max_size=2), scalars, max_size=2)


def shaped(arg):
    """Arrays that fit, or nearly, full of numbers that are often the special ones."""
    shapes = st.lists(st.integers(0, 3), max_size=2).map(lambda outer: (*outer, *arg.core))
    elements = st.sampled_from(SPECIAL) | st.floats(-10, 10) | st.integers(-9, 9).map(float)
    return hnp.arrays(float, shapes, elements=elements)


def damaged(arg):
    """The working value with a few of its numbers replaced, or turned or scaled as a whole."""
    good = arg.good
    if arg.kind in ("name", "frame"):
        return st.sampled_from(WORDS)
    if arg.kind == "wheels":
        return st.lists(st.sampled_from(good), max_size=4)
    good = np.asarray(good, dtype=float)
    where = st.lists(st.tuples(*(st.integers(0, n - 1) for n in good.shape)), max_size=2)
    return st.builds(
        lambda where, value, scale: spoil(np.array(good * scale), where, value),
        where,
        st.sampled_from(SPECIAL),
        st.sampled_from([1.0, 1.0, -1.0, 0.0, 1 + 1e-15, 1 + 1e-7, 1e300]),
    )


def spoil(array, where, value):
    for index in where:
        array[index] = value
    return array


def throw_junk(label, examples):
    """Call a function with junk in place of each argument alone, and of several at once.

    Returns the number of calls: CASES + 4 for each argument, for every example.
    """
    replacements = {
        key: st.lists(junk | shaped(arg) | damaged(arg), min_size=4, max_size=4)
        for key, arg in TABLE[label].args.items()
    }
    count = longest = 0

    @settings(max_examples=examples, database=None, suppress_health_check=list(HealthCheck))
    @given(st.fixed_dictionaries(replacements), st.integers(0, 2**32))
    def catch(drawn, seed):
        nonlocal count, longest
        chance = random.Random(seed)
        changes = [{key: value} for key, values in drawn.items() for value in values]
        for case in range(CASES):
            share = (0.3, 0.5, 0.7, 1.0)[case % 4]
            some = [key for key in drawn if chance.random() < share]
            changes.append({key: chance.choice(drawn[key]) for key in some})
        for changed in changes:
            count += 1
            try:
                call(label, **changed)
            except RobokinError as error:
                longest = max(longest, len(str(error)))

    catch()
    assert longest < 1000, f"a message of {longest} characters, allowed 999: cut what was got"
    return count


# hypothesis, when it draws again, wants to print the strategy, and warns that it is long
quiet = pytest.mark.filterwarnings("ignore:Generating overly large repr")


@quiet
@each_row()
def test_junk_finds_nothing_but_robokin_errors(label):
    throw_junk(label, examples=10)


@quiet
@pytest.mark.slow
def test_a_million_cases_of_junk_find_nothing_but_robokin_errors(capsys):
    total = 0
    for label, entry in TABLE.items():
        cases = CASES + 4 * len(entry.args)
        total += throw_junk(label, examples=1_000_000 // (len(TABLE) * cases) + 1)
    with capsys.disabled():
        print(f"\n{total} cases of junk in {len(TABLE)} rows: nothing but RobokinError")
    assert total >= 1_000_000

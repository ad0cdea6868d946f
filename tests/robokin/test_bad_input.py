"""What all functions have in common, for every row in `arguments.py`: batches, and bad input."""

import inspect
import itertools

import numpy as np
import pytest
from arguments import DATA, MODULES, PARAMETERS, STEPS, TABLE, bind, public_functions
from support import METHODS

from robokin.errors import RobokinError
from robokin.frames import compose


def call(label, **changed):
    """Call the function of a row with its working arguments, some of them changed."""
    function, positional, named = bind(label, **changed)
    return function(*positional, **named)


def results(label, **changed):
    """The results as a list of arrays, however many there are."""
    result = call(label, **changed)
    return [np.asarray(a) for a in (result if isinstance(result, tuple) else (result,))]


def varied(arg, i):
    """The i-th of many values that work: scaled, counted on or, a matrix, turned."""
    value = np.array(arg.value, dtype=float)
    if arg.kind == "matrix":
        turn = np.eye(len(value))
        turn[:2, :2] = [[np.cos(i), -np.sin(i)], [np.sin(i), np.cos(i)]]
        return turn @ value
    whole = arg.kind in ("ticks", "tick steps", "bits", "modulus")
    return value + i if whole else value * (1 + i / 64)


def batch(entry, shape, kinds=DATA):
    """Working arguments of these kinds in a batch, all of its items different."""
    return {
        key: np.array([varied(entry.args[key], i) for i in range(np.prod(shape))]).reshape(
            (*shape, *entry.args[key].core)
        )
        for key in entry.having(*kinds)
    }


def kinds_with_batches(entry):
    return DATA + (PARAMETERS if entry.batches else ())


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
    return pytest.mark.parametrize("label", [label for label in TABLE if wanted(TABLE[label])])


def assert_refused(label, key=None, **changed):
    """A RobokinError that names the argument."""
    with pytest.raises(RobokinError) as error:
        call(label, **changed)
    message = str(error.value)
    # transforms without names are numbered; a graph names poses and frames by the frames
    if key is not None and not TABLE[label].positional and not TABLE[label].on:
        assert key in message, f"the message does not name the argument {key}: {message}"
    return message


def has_results(entry):
    return bool(entry.results)


def has_data(entry):
    return bool(entry.results and entry.having(*DATA))


@pytest.mark.parametrize("module", MODULES)
def test_each_function_has_a_row(module):
    functions = set(public_functions(module))
    named = {label.split()[0] for label in TABLE if label.startswith(f"{module}.")}
    missing, gone = sorted(functions - named), sorted(named - functions)
    assert not missing, f'add "{missing[0]}": row(…) to TABLE of tests/robokin/arguments.py'
    assert not gone, f"take {gone} out of TABLE of tests/robokin/arguments.py"


# What works


@each_row(has_results)
def test_one_item_in_one_item_out(label):
    assert [a.shape for a in results(label)] == TABLE[label].results
    assert all(np.isfinite(a).all() for a in results(label))


@each_row(has_results)
def test_an_item_of_a_batch_is_as_alone(label):
    """Data alone in a batch, parameters too, and each argument by itself."""
    entry = TABLE[label]
    many = batch(entry, (2, 3), kinds_with_batches(entry))
    for keys in (entry.having(*DATA), list(many), *([key] for key in many)):
        if keys:
            together = results(label, **{key: many[key] for key in keys})
            for index in np.ndindex(2, 3):
                alone = results(label, **{key: many[key][index] for key in keys})
                for a, b in zip(together, alone, strict=True):
                    # NumPy's vector sines may differ from its single ones in the last digit
                    np.testing.assert_allclose(a[index], b, rtol=0, atol=1e-13)


@each_row(has_data)
def test_batches_broadcast(label):
    """One argument in a batch (2, 1), the others in one of 3."""
    entry = TABLE[label]
    kinds = kinds_with_batches(entry)
    rows, columns = batch(entry, (2, 1), kinds), batch(entry, (3,), kinds)
    for key in rows:
        together = results(label, **columns | {key: rows[key]})
        for i, k in np.ndindex(2, 3 if len(columns) > 1 else 1):
            alone = {other: array[k] for other, array in columns.items()} | {key: rows[key][i, 0]}
            for a, b in zip(together, results(label, **alone), strict=True):
                np.testing.assert_allclose(a[i, k], b, rtol=0, atol=1e-13)


@each_row(has_data)
def test_an_empty_batch_gives_an_empty_result(label):
    entry = TABLE[label]
    for empty in ((0,), (3, 0)):
        many = {key: np.empty((*empty, *entry.args[key].core)) for key in entry.having(*DATA)}
        wanted = [(*empty, *shape) for shape in entry.results]
        assert [a.shape for a in results(label, **many)] == wanted
        for key in many:  # or one argument empty, the others single
            assert [a.shape for a in results(label, **{key: many[key]})] == wanted


@each_row(lambda entry: entry.results is not None)
def test_lists_tuples_and_arrays_are_the_same_and_stay_as_they_are(label):
    entry = TABLE[label]
    keys = entry.having(*DATA, *PARAMETERS)
    arrays = {key: np.array(entry.args[key].value) for key in keys}
    for array in arrays.values():
        array.flags.writeable = False  # nothing may write into what it was given
    tuples = {key: to_tuple(entry.args[key].value) for key in keys}
    columns = {key: np.array(array, order="F") for key, array in arrays.items()}
    for changed in (arrays, tuples, columns):
        for a, b in zip(results(label, **changed), results(label), strict=True):
            np.testing.assert_array_equal(a, b)


def to_tuple(value):
    return tuple(map(to_tuple, value)) if isinstance(value, list) else value


@each_row(has_data)
def test_the_result_is_one_s_own(label):
    given = batch(TABLE[label], (3,))
    kept = {key: array.copy() for key, array in given.items()}
    for array in results(label, **given):
        if array.dtype == float:
            array[...] = 7.0  # can be written into, and is no view of an argument
    for key, array in given.items():
        np.testing.assert_array_equal(array, kept[key])


# What is refused: shapes and types


@each("data", "matrix", "length", "number")
def test_a_wrong_shape_is_refused(label, key):
    core = TABLE[label].args[key].core
    if core and key != "dt":
        *outer, last = core
        wrong = [np.ones((*outer, last + 1)), np.ones((5, *outer, last + 1))]
        if label != "wheels.omni_robot":  # which takes any number of angles
            for value in [*wrong, 1.0, np.ones(last)] if outer else [*wrong, 1.0]:
                assert_refused(label, **{key: value})


@each_row()
def test_batches_of_different_lengths_are_refused(label):
    entry = TABLE[label]
    kinds = kinds_with_batches(entry)
    two, three = batch(entry, (2,), kinds), batch(entry, (3,), kinds)
    for key, other in itertools.permutations(two, 2):
        assert_refused(label, **{key: two[key], other: three[other]})


@each_row(lambda entry: entry.having(*STEPS))
def test_paths_of_different_lengths_are_refused(label):
    args = TABLE[label].args
    keys = [key for key in args if args[key].core[-1:] == (4,)]
    for key, other in itertools.permutations(keys, 2):
        assert_refused(label, **{key: args[other].value[:3]})


NOT_NUMBERS = ["1.0", ["1", "2", "3"], object(), {"x": 1.0}, 1j, [[1.0], [1.0, 2.0]], True]
NOT_NUMBERS += [[1.0, None, 3.0], np.ma.masked_array([1.0, 2.0], [False, True])]


@each_argument()
def test_what_is_not_numbers_is_refused(label, key):
    for value in NOT_NUMBERS:
        if TABLE[label].args[key].kind != "frame" or not isinstance(value, str):
            assert_refused(label, key, **{key: value})


def test_what_is_masked_is_refused_with_the_remedy():
    row = np.ma.masked_array([0.1, 0.2, 99], mask=[False, False, True])
    for value in (row, row[:2], [row, row], [0.1, np.ma.masked]):
        message = assert_refused("motion.wrap_angle", "angle", angle=value)
        assert ".filled(np.nan)" in message


@each_argument()
def test_none_is_refused_but_where_it_is_the_default(label, key):
    parameters = inspect.signature(bind(label)[0]).parameters
    if key not in parameters or parameters[key].default is not None:
        assert_refused(label, key, **{key: None})


@each("name")
def test_an_unknown_name_is_refused(label, key):
    for value in ("", "no such", "EXACT", "Raise", 3, ["nan"]):
        message = assert_refused(label, key, **{key: value})
        if key != "seq":
            assert TABLE[label].args[key].value in message  # says what is allowed


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
    for value in (1.0, "wheels", [1.0], [None], np.ones(3), [TABLE[label].args[key].value]):
        assert_refused(label, key, **{key: value})


@pytest.mark.parametrize("arguments", [(1, 2, 3), (), (1,)])
def test_a_call_that_python_refuses_is_python_s_error(arguments):
    function, _, _ = bind("motion.to_world")
    with pytest.raises(TypeError, match="to_world"):
        function(*arguments)
    with pytest.raises(TypeError, match="multiple values"):
        function(1, [1, 2, 3], theta=1)


# What is refused: values of parameters

NEVER = {
    "length": [0.0, -1.0, np.nan, np.inf],
    "not negative": [-1e-300, np.nan, np.inf],
    "number": [np.nan, -np.inf],
    "bits": [0, 1.5, 64, np.nan],
    "modulus": [1, 300.5, 2.0**53, np.nan],
}


@each(*PARAMETERS)
def test_a_parameter_that_cannot_be_meant_is_refused(label, key):
    """One bad number is enough, and the message says which."""
    entry = TABLE[label]
    arg = entry.args[key]
    for value in NEVER[arg.kind]:
        bad = np.array(arg.value, dtype=float)
        bad[(-1,) * bad.ndim] = value
        assert_refused(label, key, **{key: bad.tolist()})
        if entry.batches:
            many = batch(entry, (3,), [arg.kind])[key].astype(float)
            many[(1,) * many.ndim] = value
            assert "at index 1" in assert_refused(label, key, **{key: many})


@each("ticks", "tick steps")
def test_ticks_are_whole_numbers(label, key):
    bad = np.array(TABLE[label].args[key].value, dtype=float)
    bad[(-1,) * bad.ndim] = 3.0000001
    assert_refused(label, key, **{key: bad})


# NaN, infinity and huge numbers in the data


def moved(arg, index):
    """The working value with one of its numbers a little larger."""
    value = np.array(arg.value, dtype=float)
    value[index] += 1.0 if arg.kind in ("ticks", "tick steps") else 0.01
    return value


def assert_lost(result, clean, depends, value):
    """What depends on a NaN is NaN, on an infinity not finite; the rest is NaN or as it was."""
    if result.dtype == bool:
        assert not result[depends].any()
    else:
        kept = (result == clean) & ~depends
        assert (kept | (np.isnan(result) if np.isnan(value) else ~np.isfinite(result))).all()


def same(entry, n):
    """The working data, n times over; row by row in memory, as NumPy may add up in another order
    where it is not, and what is compared to the last digit would differ by it."""
    return {
        key: np.broadcast_to(entry.args[key].value, (n, *entry.args[key].core)).copy("C")
        for key in entry.having(*DATA)
    }


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
@each("data", "ticks", wanted=has_data)
def test_a_bad_value_goes_into_what_depends_on_it_and_touches_no_other_row(label, key, value):
    entry = TABLE[label]
    clean, one = same(entry, 5), results(label)
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
@each("matrix", wanted=has_data)
def test_a_matrix_with_a_bad_value_is_not_judged_and_gives_nan(label, key, value):
    entry = TABLE[label]
    clean = same(entry, 5)
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
    clean = same(entry, 3)
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
    target = np.array(TABLE[label].args[key].value)
    for i in range(3):
        bad = np.array([target, target])
        bad[1, i] = value
        out = call(label, **{key: bad, "unreachable": "raise"})
        assert np.isfinite(out[0]).all()
        assert np.isnan(out[1]).any()


EXTREMES = [1e308, -1e308, 5e-324, 1e-200, 0.0]


@each_row(lambda entry: not entry.bounded)
def test_the_largest_and_the_smallest_numbers_touch_no_other_row_and_warn_of_nothing(label):
    # in each of the data, and with each parameter: a warning would be an error here
    entry = TABLE[label]
    clean = same(entry, 3)
    for value, key in itertools.product(EXTREMES, entry.having("data", "steps")):
        extreme = clean[key].astype(float)
        extreme[1] = value
        out = results(label, **{**clean, key: extreme})
        for a, b in zip(out, results(label, **clean), strict=True):
            np.testing.assert_array_equal(a[[0, 2]], b[[0, 2]])
    for value, key in itertools.product(EXTREMES, entry.having("length", "number", "not negative")):
        if value > 0:
            call(label, **{key: np.full(entry.args[key].core, value)})


@each("matrix")
def test_one_matrix_that_is_no_rotation_is_refused(label, key):
    for value in EXTREMES:
        matrices = batch(TABLE[label], (3,))[key]
        matrices[1] = value
        assert "at index 1" in assert_refused(label, key, **{key: matrices})

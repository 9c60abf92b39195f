"""Assertions for test suites: that lines or a picture are as a reference has them.

A reference that is missing, or does not hold, fails the test with what changed, and leaves what was found ("candidate")
and a picture of the difference in a folder. Look at them; with INKEDGE_ACCEPT=1 in the environment the same test makes
the candidate the reference.
"""
import os
import pathlib
import shutil

from . import Lines, Maps, compare_lines, compare_pictures, write_png

__all__ = ["assert_same_lines", "assert_same_picture"]


def assert_same_lines(actual, reference, *, distance=1.5, share=0.0, speck=4.0, folder="candidates"):
    """Fails unless the lines are those of a reference.

    actual: Lines, or the path of lines as .json or .svg, or of a picture
    reference: path of lines as .json or .svg, or of a picture; of one size with actual
    distance: pixels; lines that run along each other this near are the same
    share: 0 to 1; of the length of all lines, how much may have changed
    speck: pixels; shorter changes are left out
    folder: where the candidate and the difference, an .svg, are left if it fails
    """
    reference = pathlib.Path(reference)
    candidate, difference = _left_in(folder, reference, ".svg")
    if isinstance(actual, Lines):
        if reference.suffix.lower() not in (".json", ".svg"):
            candidate = candidate.with_suffix(".svg")
        actual.write(candidate)
    else:
        candidate = candidate.with_suffix(pathlib.Path(actual).suffix)
        shutil.copyfile(actual, candidate)
    if _accepts(candidate, reference):
        return
    found = compare_lines(reference, candidate, distance=distance, share=share, speck=speck)
    if found.same:
        candidate.unlink()
        return
    found.write(difference)
    raise AssertionError(_failure(str(found).rstrip(), candidate, reference, difference))


def assert_same_picture(actual, reference, *, level=0.0, share=0.0, hard_limit=None, folder="candidates"):
    """Fails unless a picture is that of a reference.

    actual: uint8 array, (height, width) or (height, width, 3 or 4), or Maps, whose "picture" it is, or a path
    reference: path of a picture; a .png unless actual is a path
    level: 0 to 1; differences up to this do not count
    share: 0 to 1; of the pixels, how many may differ by more
    hard_limit: 0 to 1; no pixel may differ by more. None: no limit where a share is allowed, else the level
    folder: where the candidate and the difference, a .png, are left if it fails
    """
    reference = pathlib.Path(reference)
    candidate, difference = _left_in(folder, reference, ".png")
    if isinstance(actual, (str, os.PathLike)):
        candidate = candidate.with_suffix(pathlib.Path(actual).suffix)
        shutil.copyfile(actual, candidate)
    else:
        write_png(candidate, actual["picture"] if isinstance(actual, Maps) else actual)
    if _accepts(candidate, reference):
        return
    found = compare_pictures(reference, candidate, level=level, share=share, hard_limit=hard_limit,
                             difference=difference)
    if found.same:
        candidate.unlink()
        difference.unlink()
        return
    raise AssertionError(_failure(str(found), candidate, reference, difference))


def _left_in(folder, reference, suffix):
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    difference = folder / f"{reference.stem}.difference{suffix}"
    difference.unlink(missing_ok=True)
    return folder / reference.name, difference


def _accepts(candidate, reference):
    """Makes the candidate the reference if that is asked for; fails if there is none."""
    if os.environ.get("INKEDGE_ACCEPT", "") not in ("", "0"):
        if candidate.suffix.lower() != reference.suffix.lower():
            raise AssertionError(f"{reference}: expected a reference of the candidate's format, {candidate.suffix}; "
                                 "name one so")
        reference.parent.mkdir(parents=True, exist_ok=True)
        os.replace(candidate, reference)
        return True
    if not reference.exists():
        raise AssertionError(f"{reference}: expected a reference, found none; look at {candidate} and, if it is right, "
                             "run the test with INKEDGE_ACCEPT=1")
    return False


def _failure(found, candidate, reference, difference):
    return (f"{found}\n  candidate  {candidate}\n  reference  {reference}\n  difference {difference}\n"
            "if the candidate is right, run the test with INKEDGE_ACCEPT=1")

"""Pictures, the player, axes."""

from xml.etree import ElementTree

import numpy
import pytest

import asv


@pytest.fixture
def solved(past_a_box):
    return asv.solve(past_a_box, "rrt-connect", optimize=0, keep_trees=True)


def test_notebooks_show_pictures(solved, past_a_box):
    for shown in (solved, solved.draw(), asv.draw(past_a_box)):
        assert ElementTree.fromstring(shown._repr_svg_()).tag == "{http://www.w3.org/2000/svg}svg"


def test_pictures_are_saved_by_their_ending(solved, tmp_path):
    picture = solved.draw(title="Past a box", theme="dark")
    for name, beginning in (("p.svg", b"<?xml"), ("p.png", b"\x89PNG"), ("p.pdf", b"%PDF")):
        picture.save(tmp_path / name)
        assert (tmp_path / name).read_bytes().startswith(beginning)
    assert picture.png.startswith(b"\x89PNG") and picture.pdf.startswith(b"%PDF")
    assert "Past a box" in picture.svg
    with pytest.raises(ValueError, match="there are svg"):
        picture.save(tmp_path / "p.gif")
    with pytest.raises(asv.WriteError):
        picture.save(tmp_path / "none" / "p.svg")


def test_the_player_is_a_frame_in_a_notebook(solved, tmp_path):
    player = solved.player()
    assert player.html.lstrip().lower().startswith("<!doctype html>")
    frame = player._repr_html_()
    assert frame.startswith("<iframe srcdoc=") and frame.count('"', 0, frame.index("title=")) == 2
    player.save(tmp_path / "p.html")
    assert (tmp_path / "p.html").read_text() == player.html
    assert len(asv.player(solved.problem).html) < len(player.html)


def test_what_cannot_be_drawn(solved, past_a_box):
    with pytest.raises(ValueError, match="number of ASVs"):
        asv.draw(past_a_box, asv.Solution(numpy.zeros((2, 4, 2))))
    with pytest.raises(ValueError, match="no state"):
        asv.draw(past_a_box, asv.Solution(numpy.zeros((0, 3, 2))))
    with pytest.raises(ValueError, match="there are light"):
        asv.draw(past_a_box, theme="blue").svg


def test_trees_survive_writing_and_reading(solved, tmp_path):
    asv.write_trees(tmp_path / "t.json", solved.trees)
    again = asv.read_trees(tmp_path / "t.json")
    for one, other in zip(again.trees, solved.trees.trees):
        assert one.root == other.root and numpy.array_equal(one.points, other.points)
        assert numpy.array_equal(one.parents, other.parents)
    assert asv.draw(solved.problem, trees=again).svg


def test_axes_of_matplotlib(solved, tmp_path):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    from matplotlib import pyplot

    axes = asv.plot(solved.problem, solved)
    assert len(axes.lines) == 2 and len(axes.collections) == 3
    assert asv.plot(solved.problem, axes=axes) is axes and axes.get_xlim() == (0, 1)
    axes.figure.savefig(tmp_path / "axes.png")
    pyplot.close(axes.figure)

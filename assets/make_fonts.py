"""Give the interface fonts the narrow spaces that group digits (U+202F and U+2009).

The subset of Inter in assets/fonts has no narrow space of its own. This adds an empty glyph of 0.17 em to
each CaromSans and CaromDisplay file, so that "12 112" can be set by any program. Running it again changes
nothing. Needs fontTools:

    python assets/make_fonts.py
"""

from pathlib import Path

from fontTools.misc.psCharStrings import T2CharString
from fontTools.ttLib import TTFont

FOLDER = Path(__file__).parent / "fonts"
NAME = "uni202F"
CODES = (0x202F, 0x2009)
WIDTH_EM = 0.17


def add_narrow_space(path: Path) -> bool:
    """Add the glyph to one font file; False if it is there already."""
    font = TTFont(path, recalcTimestamp=False)
    if CODES[0] in font.getBestCmap():
        return False
    width = round(WIDTH_EM * font["head"].unitsPerEm)
    top = font["CFF "].cff.topDictIndex[0]
    strings = top.CharStrings
    private = top.Private
    glyph = T2CharString(
        program=[width - private.nominalWidthX, "endchar"], private=private, globalSubrs=top.GlobalSubrs
    )
    strings.charStringsIndex.append(glyph)
    strings.charStrings[NAME] = len(strings.charStringsIndex) - 1
    font.setGlyphOrder([*font.getGlyphOrder(), NAME])
    top.charset = font.getGlyphOrder()
    font["hmtx"].metrics[NAME] = (width, 0)
    for table in font["cmap"].tables:
        for code in CODES:
            table.cmap[code] = NAME
    font.save(path)
    return True


if __name__ == "__main__":
    for file in sorted(FOLDER.glob("Carom*.otf")):
        print(file.name, "changed" if add_narrow_space(file) else "has it already")

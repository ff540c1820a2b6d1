#!/usr/bin/env python3
"""A style that was exported as AAMA and as ASTM gives the same panels and seams. By ctest."""
import unittest

import labels
import sameness

FOLDER = labels.DATA / "industrial-dxf"
DIALECTS = ("_AAMA", "_ASTM")


def twins():
    """Pairs of drawings whose names differ in the dialect alone."""
    if not FOLDER.is_dir():
        return []
    files = {file.name.upper(): file for file in FOLDER.iterdir()}
    return [(files[name], files[name.replace(*DIALECTS)]) for name in sorted(files)
            if DIALECTS[0] in name and name.replace(*DIALECTS) in files]


@unittest.skipUnless(twins(), "no real drawings here: AAMA and ASTM are not compared")
class TwinsTest(unittest.TestCase):
    def test_both_dialects_give_the_same_panels_and_seams(self):
        for i, pair in enumerate(twins()):
            with self.subTest(i):  # names of these files are not told
                aama, astm = (sameness.Pattern(file, [], True) for file in pair)
                self.assertEqual(list(aama.panels), list(astm.panels))
                self.assertEqual(sameness.panels_that_differ(aama, astm), [])
                self.assertEqual(aama.notches, astm.notches)
                self.assertEqual(aama.quantities, astm.quantities)
                self.assertEqual(sameness.seams_that_differ(aama, astm), ([], []))


if __name__ == "__main__":
    unittest.main()

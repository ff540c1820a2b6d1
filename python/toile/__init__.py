"""Dresses a body with flat sewing patterns and reports how the garment fits: docs/python.md."""
from toile._toile import (Body, Drape, Error, Garment, Mesh, SewingPattern, clean, dress, ease,
                          find_seams, gaps, import_pattern, judge, mannequin, measure, mesh,
                          read_body, read_drape, read_garment, read_mesh, read_pattern, write)

__all__ = ["Body", "Drape", "Error", "Garment", "Mesh", "SewingPattern", "clean", "dress", "ease",
           "find_seams", "gaps", "import_pattern", "judge", "mannequin", "measure", "mesh",
           "read_body", "read_drape", "read_garment", "read_mesh", "read_pattern", "write"]

for _name in __all__:
    globals()[_name].__module__ = "toile"

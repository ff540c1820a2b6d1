"""Figures of a drape that have an error, read from the report of ease-map."""
import json


def figures(report):
    """Each figure that has an error, by where it stands, as (value, error)."""
    found = {}

    def collect(value, place):
        if isinstance(value, list):
            for item in value:
                collect(item, place)
        if not isinstance(value, dict):
            return
        name = value.get("name") or value.get("place") or value.get("height_cm") or ""
        place = f"{place}/{name}"
        for key, of_key in value.items():
            collect(of_key, f"{place}/{key}")
            of = value.get(key.removeprefix("plus_minus_"))
            if key.startswith("plus_minus_") and isinstance(of, (int, float)):
                found[f"{place}/{key.removeprefix('plus_minus_')}"] = (of, of_key)

    collect(json.loads(report.read_text()), "")
    return found

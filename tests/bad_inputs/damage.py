"""Ways to damage sound inputs. Each takes a random.Random and the case's folder, changes a file
there, and returns the command to run and the names one of which its message has to say."""
import json
import shutil

import good

NUMBERS = ("nan", "inf", "-inf", "1e300", "-1e300", "1e999", "1e18", "1e15", "1e-300", "-1", "0",
           "1", "4294967296", "-2147483649", "99999999999999999999", "0x10", "1,5", "--1", "1e")
WORDS = ("", "x", "\u00e4\u0303", "../../etc/passwd", "panel with spaces", "a" * 5000, "\x07", "#",
         "nan", "null")


def take(random, folder, names):
    """A sound file of `names`, its command, and its path, copied with all that the command reads."""
    name = random.choice(names)
    words = random.choice(good.commands(name))
    copy(folder, good.needed(words) | {name} | set(good.BESIDE.get(name, [])))
    return name, words, folder / name


def copy(folder, names):
    for name in names:
        shutil.copy(folder.parent / "good" / name, folder / name)


def truncated(random, folder):
    name, words, path = take(random, folder, good.ALL)
    data = path.read_bytes()
    path.write_bytes(data[:random.randrange(len(data))])
    return words, [name]


def bytes_flipped(random, folder):
    name, words, path = take(random, folder, good.ALL)
    data = bytearray(path.read_bytes())
    head = random.random() < 0.5  # where formats are declared
    for _ in range(random.randint(1, 8)):
        data[random.randrange(min(len(data), 400) if head else len(data))] ^= 1 << random.randrange(8)
    path.write_bytes(data)
    return words, [name]


def lines_deleted(random, folder):
    name, words, path = take(random, folder, good.TEXTS)
    lines = path.read_bytes().split(b"\n")
    for _ in range(random.randint(1, 3)):
        at = random.randrange(len(lines))
        del lines[at:at + random.randint(1, 5)]
    path.write_bytes(b"\n".join(lines))
    return words, [name]


def number_replaced(random, folder):
    name, words, path = take(random, folder, good.TEXTS)
    text = path.read_text()
    starts = [i for i in range(1, len(text)) if text[i] in "-0123456789" and
              text[i - 1] in " \t\n[,/:"]
    for _ in range(random.randint(1, 2)):
        at = random.choice(starts)
        end = at
        while end < len(text) and text[end] in "-+.e0123456789":
            end += 1
        text = text[:at] + random.choice(NUMBERS) + text[end:]
        starts = [start for start in starts if start < at] or [at]
    path.write_text(text)
    return words, [name]


def garbage(random, folder):
    name, words, path = take(random, folder, good.ALL)
    path.write_bytes(random.randbytes(random.choice((0, 1, 3, 84, 1000, 100000))))
    return words, [name]


def not_utf8(random, folder):
    name, words, path = take(random, folder, good.TEXTS)
    data = path.read_bytes()
    at = random.randrange(len(data))
    path.write_bytes(data[:at] + random.choice((b"\xff\xfe", b"\xc0\x80", b"\xed\xa0\x80", b"\0")) +
                     data[at:])
    return words, [name]


def a_folder(random, folder):
    name, words, path = take(random, folder, good.ALL)
    path.unlink()
    path.mkdir()
    return words, [name]


def missing(random, folder):
    name, words, path = take(random, folder, good.ALL)
    path.unlink()
    return words, [name]


def edited(change):
    """A damage that changes the parsed content of a JSON file by `change`."""
    def damage(random, folder, names=good.JSONS):
        name, words, path = take(random, folder, names)
        content = json.loads(path.read_text())
        text = change(random, content)
        path.write_text(text if isinstance(text, str) else json.dumps(content))
        return words, [name]
    return damage


def places(value, found=None):
    """All (container, key) within a JSON value."""
    found = [] if found is None else found
    for key in (value if isinstance(value, dict) else range(len(value))):
        found.append((value, key))
        if isinstance(value[key], (dict, list)):
            places(value[key], found)
    return found


def wrong_type(random, content):
    holder, key = random.choice(places(content))
    holder[key] = random.choice((None, True, -1, 0, 1.5, 10**25, "text", "", [], {}, [[]],
                                 {"x": 1}, [1, 2, 3], 1e300, [0] * 1000, random.choice(WORDS)))


def key_dropped(random, content):
    holder, key = random.choice(places(content))
    del holder[key]


def key_renamed(random, content):
    holder, key = random.choice([place for place in places(content) if isinstance(place[0], dict)])
    holder[random.choice(WORDS)] = holder.pop(key)


def entry_doubled(random, content):
    lists = [place for place in places(content) if isinstance(place[0][place[1]], list)]
    holder, key = random.choice(lists or [(content, random.choice(list(content)))])
    if isinstance(holder[key], list) and holder[key]:
        holder[key].append(random.choice(holder[key]))


def nested(random, content):
    depth = random.choice((101, 5000, 140000))
    opening, closing = random.choice((("[", "]"), ('{"a":', "}")))
    text = json.dumps(content)
    deep = opening * depth + "1" + closing * depth
    return text[:-1] + ', "deep": ' + deep + "}" if random.random() < 0.5 else deep


def key_twice(random, content):
    key = random.choice(list(content))
    return json.dumps(content)[:-1] + f", {json.dumps(key)}: {json.dumps(content[key])}}}"


def rows(path, keyword):
    lines = path.read_text().split("\n")
    return lines, [i for i, line in enumerate(lines) if line.startswith(keyword + " ")]


def mesh_changed(change):
    """A damage that changes the lines of an OBJ file's points and faces by `change`."""
    def damage(random, folder):
        name, words, path = take(random, folder, ("mesh.obj", "garment.obj", "dressed.obj"))
        lines, points = rows(path, "v")
        _, faces = rows(path, "f")
        change(random, lines, points, faces)
        path.write_text("\n".join(lines))
        return words, [name]
    return damage


def far_point(random, lines, points, _):
    at = random.choice(points)
    words = lines[at].split()
    words[random.randint(1, 3)] = random.choice(("1e15", "-1e18", "1e300", "999", "-1e5", "1e6"))
    lines[at] = " ".join(words)


def scaled(random, lines, points, _):
    factor = random.choice((100, 1000, 0.01, 39.37, 1e-6, 1e5, 0))
    for at in points:
        lines[at] = "v " + " ".join(repr(factor * float(word)) for word in lines[at].split()[1:4])


def flattened(random, lines, points, _):
    axis = random.randint(1, 3)
    for at in points:
        words = lines[at].split()
        words[axis] = "0"
        lines[at] = " ".join(words)


def noisy(random, lines, points, _):
    size = random.choice((0.001, 0.02, 0.3))
    for at in points:
        lines[at] = "v " + " ".join(repr(float(word) + random.gauss(0, size))
                                    for word in lines[at].split()[1:4])


def faces_doubled(random, lines, _, faces):
    lines.extend(lines[at] for at in random.sample(faces, random.choice((1, 20, len(faces)))))


def faces_turned(random, lines, _, faces):
    for at in random.sample(faces, random.choice((1, 20, len(faces) // 2))):
        words = lines[at].split()
        lines[at] = " ".join([words[0]] + words[:0:-1])


def faces_dropped(random, lines, _, faces):
    for at in random.sample(faces, random.choice((1, 20, len(faces) // 2, len(faces)))):
        lines[at] = ""


def index_replaced(random, lines, _, faces):
    at = random.choice(faces)
    words = lines[at].split()
    words[random.randrange(1, len(words))] = random.choice(
        ("0", "-1", "2147483648", "99999999999999999999", "1/0", "1/99999999", "7//", "x", "1.5"))
    lines[at] = " ".join(words)


def face_of_all(random, lines, points, _):
    lines.append("f " + " ".join(str(i + 1) for i in range(len(points))))


def groups_of(path):
    """A DXF file as a list of [code, value]."""
    lines = path.read_text().split("\n")
    return [[lines[i], lines[i + 1]] for i in range(0, len(lines) - 1, 2)]


def drawing_changed(change):
    """A damage that changes the groups of the drawing by `change`."""
    def damage(random, folder):
        name, words, path = take(random, folder, ("drawing.dxf",))
        groups = groups_of(path)
        change(random, groups)
        path.write_text("".join(f"{code}\n{value}\n" for code, value in groups))
        return words, [name]
    return damage


def coordinates(groups):
    return [group for group in groups if group[0].strip() in ("10", "20", "40", "42")]


def drawn_wildly(random, groups):
    for group in random.sample(coordinates(groups), 3):
        group[1] = random.choice(("0", "-1", "1e6", "1e300", "nan", "300.0", "299.9999", "1e-9"))


def drawn_in_another_unit(random, groups):
    factor = random.choice((1e-6, 1e-3, 0.1, 10, 1e3, 1e9))
    for group in groups:
        if group[0].strip() in ("10", "20", "11", "21", "40"):
            group[1] = repr(factor * float(group[1]))


def groups_shuffled(random, groups):
    start = random.randrange(len(groups) - 20)
    part = groups[start:start + 20]
    random.shuffle(part)
    groups[start:start + 20] = part


def many_entities(random, groups):
    at = next(i for i, group in enumerate(groups) if group[1] == "ENTITIES") + 1
    point = [["0", "POINT"], ["8", "1"], ["10", "1.0"], ["20", "2.0"]]
    groups[at:at] = point * random.choice((10, 5000, 400000))


def inserted_in_itself(random, groups):
    at = next(i for i, group in enumerate(groups) if group[1] == "LWPOLYLINE")
    groups[at:at] = [["0", "INSERT"], ["8", "1"], ["2", "FRONT"], ["10", "0.0"], ["20", "0.0"],
                     ["41", random.choice(("1", "-1", "0", "1e8", "x"))]]


def panel_of(random, content):
    panels = content["pattern"]["panels"]
    name = random.choice(list(panels))
    return name, panels[name]


def outline_crossed(random, content):
    _, panel = panel_of(random, content)
    a, b = random.sample(range(len(panel["vertices"])), 2)
    panel["vertices"][a], panel["vertices"][b] = panel["vertices"][b], panel["vertices"][a]


def vertices_equal(random, content):
    _, panel = panel_of(random, content)
    edge = random.choice(panel["edges"])["endpoints"]
    panel["vertices"][edge[0]] = list(panel["vertices"][edge[1]])


def edge_dropped(random, content):
    _, panel = panel_of(random, content)
    del panel["edges"][random.randrange(len(panel["edges"]))]


def sewn_wrong(random, content):
    stitches = content["pattern"]["stitches"]
    stitch = random.choice(stitches)
    side = random.choice(stitch[:2])
    name, panel = panel_of(random, content)
    kind = random.randrange(6)
    if kind == 0:
        side["panel"] = random.choice(WORDS)
    elif kind == 1:
        side["edge"] = random.choice((len(panel["edges"]), -1, 10**9, 10**10, 10**20))
    elif kind == 4:
        del side[random.choice(("panel", "edge"))]
    elif kind == 5:
        stitch.remove(side)
    elif kind == 2:
        stitches.append([{"panel": name, "edge": 0}, {"panel": name, "edge": 0}])
    else:
        side["panel"], side["edge"] = name, random.randrange(len(panel["edges"]))


def panel_dropped(random, content):
    name, _ = panel_of(random, content)
    del content["pattern"]["panels"][name]


def curved_wildly(random, content):
    _, panel = panel_of(random, content)
    kind, count = random.choice((("quadratic", 1), ("cubic", 2)))
    points = [[random.uniform(-9, 9), random.uniform(-9, 9)] for _ in range(count)]
    random.choice(panel["edges"])["curvature"] = random.choice((
        {"type": kind, "params": points}, {"type": "circle", "params": [1e-9, 0, 1]},
        {"type": "circle", "params": [1e12, 1, 0]}, {"type": "spline", "params": []}, [1e9, 1e9]))


def unit_replaced(random, content):
    content.setdefault("properties", {})["units_in_meter"] = random.choice(
        (0, -1, 1e-3, 0.01, 1, 1000, 39.37, 1e6, 1e9, "cm", None))


def comb(random, content):
    _, panel = panel_of(random, content)
    teeth = random.choice((40, 400, 4000))
    points = [[0, 0]]
    for i in range(teeth):
        points += [[(i + 0.4) * 60 / teeth, 40], [(i + 0.8) * 60 / teeth, 0]]
    points.append([60, -5])
    panel["vertices"] = points
    panel["edges"] = [{"endpoints": [i, (i + 1) % len(points)]} for i in range(len(points))]


def many_panels(random, content):
    _, panel = panel_of(random, content)
    for i in range(random.choice((10, 1000, 20000))):
        content["pattern"]["panels"][f"copy{i}"] = panel


def pattern_changed(change):
    def damage(random, folder):
        return edited(change)(random, folder, good.PATTERNS)
    return damage


def sidecar_misfits(random, content):
    """The garment's JSON tells of another mesh than the OBJ file beside it has."""
    panel, seam = random.choice(content["panels"]), random.choice(content["seams"])
    side = seam[random.choice("ab")]
    shift = random.choice((-1, 1, 1000, 2**31))
    change = random.choice((
        lambda: panel.update({(key := random.choice(("first_point", "points", "first_triangle",
                                                     "triangles"))): panel[key] + shift}),
        lambda: content["panels"].append(panel), lambda: content["panels"].remove(panel),
        lambda: side.pop(), lambda: side.__setitem__(0, side[0] + shift), lambda: side.clear(),
        lambda: side.reverse(), lambda: seam.update(a=seam["b"]),
        lambda: seam.update(length_a=random.choice((-1, 0, 1e-300, 1e300))),
        lambda: content.update(edge_length=random.choice((-1, 0, 1e-300, 1e300))),
        lambda: content.update(subdivisions=random.choice((0, 2, 9, 2**31))),
        lambda: content.update(attachments=[{"name": "x", "points": random.choice(
            ([], [0], [-1], [10**9], [0.5])), "to": "level", "level": "waist"}]),
        lambda: content.update(elastics=[{"name": "x", "points": random.choice(([], [0, 1], [0])),
                                          "ratio": random.choice((0, 0.5, 2)),
                                          "stiffness_N": random.choice((-1, 10, 1e300))}]),
        lambda: content.update(marks=[{"name": "x", "points": [10**9]}]),
        lambda: content.update(cut_outs=[{"name": "x", "points": [0, 0, 0]}])))
    change()


def another_sidecar(random, folder):
    """The JSON of another garment lies beside the OBJ file."""
    name, words, path = take(random, folder, ("garment.garment.json",))
    shutil.copy(folder.parent / "good" / random.choice(
        ("other.garment.json", "body.body.json", "scene.json", "pattern_band.json")), path)
    return words, [name]


def svg_changed(random, folder):
    name, words, path = take(random, folder, good.SVGS)
    text = path.read_text()
    start = text.index("<svg")
    inner = text.index(">", start) + 1
    bomb = "".join(f'<!ENTITY e{i + 1} "{f"&e{i};" * 10}">' for i in range(10))
    copies = "".join(f'<g id="c{i + 1}">{f"""<use xlink:href="#c{i}"/>""" * 10}</g>'
                     for i in range(12))
    change = random.choice((
        lambda: text[:start] + f'<!DOCTYPE svg [<!ENTITY e0 "ha">{bomb}]>' + text[start:inner] +
        "<text>&e10;</text>" + text[inner:],
        lambda: text[:start] + '<!DOCTYPE svg [<!ENTITY e SYSTEM "file:///etc/passwd">]>' +
        text[start:inner] + "<title>&e;</title>" + text[inner:],
        lambda: text[:inner] + "<script>alert(1)</script>" + text[inner:],
        lambda: text[:inner] + "<g>" * (deep := random.choice((50, 300, 100000))) + "</g>" * deep +
        text[inner:],
        lambda: text[:inner] + '<g id="ring"><use xlink:href="#ring"/></g>' + text[inner:],
        lambda: text[:inner] + f'<defs><path id="c0" d="M0 0h9v9z"/>{copies}</defs>'
        '<use xlink:href="#c12"/>' + text[inner:],
        lambda: text[:inner] + '<path d="M0 0' + "h1v1" * random.choice((10, 100000)) + 'z"/>' +
        text[inner:],
        lambda: text[:inner] + '<rect width="9" height="9"/>' * 30000 + text[inner:],
        lambda: text[:inner] + f'<g transform="scale({random.choice(NUMBERS)})">' + text[inner:].replace(
            "</svg>", "</g></svg>"),
        lambda: text.replace(" z\"", "\""), lambda: text.replace("mm\"", random.choice(
            ("px", "%", "in", "", "furlong", "em")) + "\""),
        lambda: text.replace("viewBox=\"0 0", "viewBox=\"" + random.choice(NUMBERS) + " 0"),
        lambda: text.replace("class=\"fabric\"", "class=\"fabric sa\"")))
    path.write_text(change())
    return words, [name]


def option(random, folder):
    dress = ["dress", "--body", "body.ply", "garment.obj", "-o", "out.obj"]
    mesh = ["mesh-pattern", "pattern_band.json", "-o", "out.obj"]
    render = ["render", "garment.obj", "-o", "out.png"]
    ease = ["ease-map", "--body", "body.ply", "dressed.obj", "-o", "out.html"]
    mannequin = ["make-mannequin", "-o", "out.ply"]
    export = ["export-pattern", "pattern_band.json", "-o", "out.svg"]
    words, flag = random.choice((
        (export, "--seam-allowance"), (dress, "--strain-limit"), (dress, "--shear-limit"), (dress, "--residual"),
        (dress, "--release"), (dress, "--gravity"), (dress, "--quality"), (dress, "--method"),
        (dress, "--fabric"), (dress, "--threads"), (dress + ["--method", "paper"], "--time-step"),
        (dress + ["--method", "paper"], "--restitution"),
        (dress + ["--method", "paper"], "--sewing"), (mesh, "--edge-length"),
        (mesh, "--subdivisions"), (render, "--width"), (render, "--views"), (ease, "--contact"),
        (ease, "--top"), (mannequin, "--edge-length"), (mannequin, "--pose"), (mesh, "--nonsense")))
    value = random.choice(("", "nan", "inf", "-1", "1e300", "1e-300", "x", "10", "-5mm", "1e9mm",
                           "0mm", "0,0", "0,0,0,0", "nan,0,0", "99999999999999999999", "\xff"))
    copy(folder, good.needed(words))
    return words + [f"{flag}={value}"], [flag, flag.lstrip("-"), "-o FILE"]


KINDS = {
    "truncated": truncated, "bytes flipped": bytes_flipped, "lines deleted": lines_deleted,
    "number replaced": number_replaced, "garbage": garbage, "not UTF-8": not_utf8,
    "a folder": a_folder, "missing": missing, "wrong type": edited(wrong_type),
    "key dropped": edited(key_dropped), "key renamed": edited(key_renamed),
    "entry doubled": edited(entry_doubled), "nested": edited(nested),
    "key twice": edited(key_twice), "far point": mesh_changed(far_point),
    "scaled": mesh_changed(scaled), "flattened": mesh_changed(flattened),
    "noisy": mesh_changed(noisy), "faces doubled": mesh_changed(faces_doubled),
    "faces turned": mesh_changed(faces_turned), "faces dropped": mesh_changed(faces_dropped),
    "index replaced": mesh_changed(index_replaced), "face of all": mesh_changed(face_of_all),
    "outline crossed": pattern_changed(outline_crossed),
    "vertices equal": pattern_changed(vertices_equal),
    "edge dropped": pattern_changed(edge_dropped), "sewn wrong": pattern_changed(sewn_wrong),
    "panel dropped": pattern_changed(panel_dropped),
    "curved wildly": pattern_changed(curved_wildly),
    "unit replaced": pattern_changed(unit_replaced), "comb": pattern_changed(comb),
    "many panels": pattern_changed(many_panels),
    "drawn wildly": drawing_changed(drawn_wildly),
    "drawn in another unit": drawing_changed(drawn_in_another_unit),
    "groups shuffled": drawing_changed(groups_shuffled),
    "many entities": drawing_changed(many_entities),
    "inserted in itself": drawing_changed(inserted_in_itself),
    "SVG changed": svg_changed, "option": option,
    "sidecar misfits": lambda random, folder: edited(sidecar_misfits)(
        random, folder, ("garment.garment.json",)),
    "another sidecar": another_sidecar,
}

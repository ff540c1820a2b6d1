  // The pictures: the garment as worn, and its pieces as they lie.

  // The ramp as a texture. Its ends are the colours beyond the ramp, so that the change is sharp
  // within a triangle, not blurred over it.
  const texels = 1024, beyond = 64;
  const inner = texels - 2 * beyond - 1;
  const ramp = new THREE.DataTexture(new Uint8Array(3 * texels), texels, 1, THREE.RGBFormat);
  ramp.minFilter = ramp.magFilter = THREE.NearestFilter;
  const places = new THREE.BufferAttribute(new Float32Array(2 * count), 2);

  function colourBy(map) {
    const colours = ramp.image.data;
    for (let i = 0; i < texels; ++i) {
      let colour = i < beyond ? map.below.colour : map.above.colour;
      const at = (i - beyond) / inner;
      if (at >= 0 && at <= 1) {
        const place = at * (map.steps.length - 1);
        const from = Math.min(Math.floor(place), map.steps.length - 2), part = place - from;
        colour = map.steps[from].map((c, k) => c + part * (map.steps[from + 1][k] - c));
      }
      for (let k = 0; k < 3; ++k) colours[3 * i + k] = Math.round(colour[k]);
    }
    ramp.needsUpdate = true;
    for (let i = 0; i < count; ++i) {
      const place = (map.values[i] - map.low) / (map.high - map.low);
      const u = (beyond + 0.5 + place * inner) / texels;
      places.array[2 * i] = Math.min(Math.max(u, 0.5 / texels), 1 - 0.5 / texels);
      places.array[2 * i + 1] = 0.5;
    }
    places.needsUpdate = true;
  }

  // Rods along pairs of places: lines of WebGL are one pixel wide.
  function rods(ends, radius) {
    const points = [], faces = [];
    for (let i = 0; i + 1 < ends.length; i += 2) {
      const from = new THREE.Vector3(...ends[i]), to = new THREE.Vector3(...ends[i + 1]);
      const along = to.clone().sub(from);
      if (along.length() < 1e-9) continue;
      along.normalize();
      const u = new THREE.Vector3(Math.abs(along.x) > 0.7 ? 0 : 1, Math.abs(along.x) > 0.7 ? 1 : 0, 0).cross(along).normalize();
      const v = along.clone().cross(u);
      const first = points.length / 3;
      for (const end of [from, to]) {
        for (const [p, q] of [[1, 1], [-1, 1], [-1, -1], [1, -1]]) {
          const corner = end.clone().addScaledVector(u, p * radius).addScaledVector(v, q * radius);
          points.push(corner.x, corner.y, corner.z);
        }
      }
      for (let k = 0; k < 4; ++k) {
        const l = (k + 1) % 4;
        faces.push(first + k, first + l, first + 4 + k, first + l, first + 4 + l, first + 4 + k);
      }
    }
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array(points), 3));
    geometry.setIndex(new THREE.BufferAttribute(new Uint32Array(faces), 1));
    return geometry;
  }

  // Edges of a region that one of its triangles has alone.
  function borderOf(index) {
    const seen = new Map();
    for (let t = 0; t < index.length; t += 3) {
      for (let k = 0; k < 3; ++k) {
        const a = index[t + k], b = index[t + (k + 1) % 3];
        const edge = Math.min(a, b) * count + Math.max(a, b);
        seen.set(edge, (seen.get(edge) || 0) + 1);
      }
    }
    const ends = [];
    seen.forEach((times, edge) => { if (times === 1) ends.push(Math.floor(edge / count), edge % count); });
    return new Uint32Array(ends);
  }
  const regionIndex = data.regions.map(region => triangles.subarray(3 * region.first, 3 * (region.first + region.count)));
  const regionBorder = regionIndex.map(borderOf);

  class View {
    constructor(holder, points, normals, camera) {
      this.holder = holder;
      this.camera = camera;
      // Smooth edges take half of the time where a processor draws; fine meshes look smooth without.
      this.renderer = new THREE.WebGLRenderer({ antialias: count < 20000, preserveDrawingBuffer: true });
      this.renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
      this.renderer.setClearColor(0xfbfbfa);
      holder.insertBefore(this.renderer.domElement, holder.firstChild);
      this.scene = new THREE.Scene();
      this.scene.add(camera);
      this.points = points;
      const position = new THREE.BufferAttribute(points, 3);
      const normal = normals && new THREE.BufferAttribute(normals, 3);
      this.regions = []; this.borders = []; this.wires = []; this.sunken = [];
      data.regions.forEach((region, number) => {
        const geometry = new THREE.BufferGeometry();
        geometry.setAttribute('position', position);
        if (normal) geometry.setAttribute('normal', normal);
        geometry.setAttribute('uv', places);
        geometry.setIndex(new THREE.BufferAttribute(regionIndex[number], 1));
        const kind = normals ? THREE.MeshLambertMaterial : THREE.MeshBasicMaterial;
        const mesh = new THREE.Mesh(geometry, new kind({
          map: ramp, side: THREE.DoubleSide, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 }));
        mesh.userData.region = number;
        this.regions.push(mesh);
        const line = new THREE.BufferGeometry();
        line.setAttribute('position', position);
        line.setIndex(new THREE.BufferAttribute(regionBorder[number], 1));
        this.borders.push(new THREE.LineSegments(line, new THREE.LineBasicMaterial({ color: 0x26272b })));
        this.wires.push(new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({
          color: 0x26272b, wireframe: true, transparent: true, opacity: 0.22 })));
        this.scene.add(mesh, this.borders[number], this.wires[number]);
      });
      this.marks = new THREE.Group();
      this.scene.add(this.marks);
      this.dot = new THREE.Mesh(new THREE.SphereBufferGeometry(0.006, 12, 8), new THREE.MeshBasicMaterial({ color: 0x000000 }));
      this.dot.visible = false;
      this.scene.add(this.dot);
      this.ray = new THREE.Raycaster();
    }

    // Parts that have sunk into the body are drawn nearer than they are, so that they show through.
    showSunken(map) {
      this.regions.forEach((mesh, number) => {
        const index = regionIndex[number], low = [];
        for (let t = 0; t < index.length; t += 3) {
          if ([0, 1, 2].some(k => map.values[index[t + k]] < map.low)) low.push(index[t], index[t + 1], index[t + 2]);
        }
        const under = new THREE.Mesh(mesh.geometry.clone(), mesh.material.clone());
        under.geometry.setIndex(new THREE.BufferAttribute(new Uint32Array(low), 1));
        under.material.polygonOffsetFactor = 0;
        under.material.polygonOffsetUnits = -1200;  // about 3 cm at the first view's distance
        this.sunken.push(under);
        if (low.length) this.scene.add(under);
      });
    }

    resize() {
      const width = this.holder.clientWidth, height = Math.max(this.holder.clientHeight, 1);
      this.renderer.setSize(width, height);
      this.fit(width / height);
      this.draw();
    }

    draw() {
      if (this.waiting) return;
      this.waiting = true;
      requestAnimationFrame(() => { this.waiting = false; this.render(); });
    }

    render() {
      this.renderer.render(this.scene, this.camera);
      document.documentElement.dataset.state = 'drawn';
      if (this.drawn) this.drawn();
    }

    // What lies under the pointer: {region, face, weights} or {setting}; null: nothing.
    hit(x, y, only, settings) {
      const frame = this.renderer.domElement.getBoundingClientRect();
      this.ray.setFromCamera(new THREE.Vector2(2 * (x - frame.left) / frame.width - 1, 1 - 2 * (y - frame.top) / frame.height), this.camera);
      const asked = this.regions.filter((mesh, i) => only < 0 || i === only).concat(settings);
      const found = this.ray.intersectObjects(asked)[0];
      if (!found) return null;
      if (found.object.userData.region === undefined) return { setting: found.object.userData.name };
      const face = [found.face.a, found.face.b, found.face.c];
      const corner = face.map(i => new THREE.Vector3(...this.points.subarray(3 * i, 3 * i + 3)));
      const weights = new THREE.Vector3();
      THREE.Triangle.getBarycoord(found.point, ...corner, weights);
      return { region: found.object.userData.region, face, weights: [weights.x, weights.y, weights.z] };
    }

    mark(hit) {
      this.dot.visible = Boolean(hit && hit.face);
      if (this.dot.visible) {
        const at = new THREE.Vector3();
        hit.face.forEach((i, k) => at.addScaledVector(new THREE.Vector3(...this.points.subarray(3 * i, 3 * i + 3)), hit.weights[k]));
        this.dot.position.copy(at);
      }
      this.draw();
    }

    // Lights lines: [{ends, colour}].
    light(lines) {
      for (const old of this.marks.children) old.geometry.dispose();
      this.marks.remove(...this.marks.children);
      for (const line of lines) {
        const rod = new THREE.Mesh(rods(line.ends, line.radius), new THREE.MeshBasicMaterial({ color: line.colour, depthTest: !line.onTop }));
        rod.renderOrder = 1;
        this.marks.add(rod);
      }
      this.draw();
    }

    // A picture of what is shown, width by height pixels.
    picture(width, height) {
      const ratio = this.renderer.getPixelRatio();
      this.renderer.setPixelRatio(1);
      this.renderer.setSize(width, height, false);
      this.fit(width / height);
      this.render();
      const image = this.renderer.domElement.toDataURL('image/png');
      this.renderer.setPixelRatio(ratio);
      return image;
    }
  }

  class SpaceView extends View {
    constructor(holder) {
      super(holder, worn, smoothNormals(), new THREE.PerspectiveCamera(24, 1, 0.01, 100));
      this.scene.add(new THREE.HemisphereLight(0xffffff, 0xd8d4d0, 0.62));
      const key = new THREE.DirectionalLight(0xffffff, 0.45);
      key.position.set(-0.6, 0.8, 1);
      this.camera.add(key);
      this.settings = data.settings.map(setting => {
        const mesh = new THREE.Mesh(new THREE.BufferGeometry(), new THREE.MeshLambertMaterial({ color: 0xc9c4bf }));
        mesh.geometry.setAttribute('position', new THREE.BufferAttribute(setting.points, 3));
        mesh.geometry.setIndex(new THREE.BufferAttribute(setting.triangles, 1));
        mesh.geometry.computeVertexNormals();
        mesh.userData.name = setting.name;
        this.scene.add(mesh);
        return mesh;
      });
      this.box = boxOf(worn);
      this.controls = new THREE.OrbitControls(this.camera, holder);
      this.controls.enableKeys = false;  // the page has its own
      this.controls.addEventListener('change', () => this.draw());
      this.plane = new THREE.Mesh(new THREE.PlaneBufferGeometry(1.6 * this.box.size[0], 1.6 * Math.max(this.box.size[2], 0.3)),
        new THREE.MeshBasicMaterial({ color: 0x2b62b5, transparent: true, opacity: 0.16, side: THREE.DoubleSide, depthWrite: false }));
      this.plane.rotation.x = -Math.PI / 2;
      this.plane.visible = false;
      this.scene.add(this.plane);
    }

    fit(aspect) {
      this.camera.aspect = aspect;
      this.camera.updateProjectionMatrix();
    }

    look(name) {
      const toward = new THREE.Vector3(...{ front: [0, 0, 1], back: [0, 0, -1], left: [1, 0, 0], right: [-1, 0, 0], top: [0, 1, 0.001] }[name]);
      const size = this.box.size, side = Math.abs(toward.x) > 0.5, above = Math.abs(toward.y) > 0.5;
      const across = side ? size[2] : size[0], up = above ? size[2] : size[1], deep = side ? size[0] : above ? size[1] : size[2];
      const needed = 1.16 * Math.max(up, across / this.camera.aspect, 1e-6);
      const distance = 0.5 * needed / Math.tan(0.5 * this.camera.fov * Math.PI / 180) + 0.5 * deep;
      this.camera.near = distance / 100;
      this.camera.far = distance * 20;
      this.camera.updateProjectionMatrix();
      this.controls.target.set(...this.box.centre);
      this.camera.position.set(...this.box.centre).addScaledVector(toward.normalize(), distance);
      this.controls.update();
      this.draw();
    }

    turn(across, up) {
      const offset = this.camera.position.clone().sub(this.controls.target);
      const round = new THREE.Spherical().setFromVector3(offset);
      round.theta += across;
      round.phi = Math.min(Math.max(round.phi + up, 0.01), Math.PI - 0.01);
      this.camera.position.copy(this.controls.target).add(offset.setFromSpherical(round));
      this.controls.update();
    }
  }

  class FlatView extends View {
    constructor(holder) {
      super(holder, lying, null, new THREE.OrthographicCamera(-1, 1, 1, -1, -1, 2));
      this.box = boxOf(lying);
      this.camera.position.set(this.box.centre[0], this.box.centre[1], 1);
      this.controls = new THREE.OrbitControls(this.camera, this.renderer.domElement);
      this.controls.target.set(this.box.centre[0], this.box.centre[1], 0);
      this.controls.enableRotate = false;
      this.controls.enableKeys = false;
      this.controls.screenSpacePanning = true;
      this.controls.mouseButtons = { LEFT: THREE.MOUSE.PAN, MIDDLE: THREE.MOUSE.DOLLY, RIGHT: THREE.MOUSE.PAN };
      this.controls.update();
      this.controls.addEventListener('change', () => this.draw());
      this.names = data.regions.map((region, number) => {
        const name = document.createElement('span');
        name.textContent = region.name;
        name.translate = false;
        name.setAttribute('translate', 'no');
        name.style.cssText = 'position:absolute;transform:translate(-50%,0);font-size:.75rem;pointer-events:none;white-space:nowrap;overflow:hidden;text-overflow:ellipsis';
        name.title = region.name;
        holder.appendChild(name);
        const index = regionIndex[number];
        const box = { left: Infinity, right: -Infinity, bottom: Infinity };
        for (const i of index) {
          box.left = Math.min(box.left, lying[3 * i]);
          box.right = Math.max(box.right, lying[3 * i]);
          box.bottom = Math.min(box.bottom, lying[3 * i + 1]);
        }
        return { name, at: new THREE.Vector3((box.left + box.right) / 2, box.bottom, 0), width: box.right - box.left + 0.03, used: index.length > 0 };
      });
    }

    fit(aspect) {
      const half = 0.53 * Math.max(this.box.size[1], this.box.size[0] / aspect, 1e-6);
      Object.assign(this.camera, { left: -half * aspect, right: half * aspect, top: half, bottom: -half });
      this.camera.updateProjectionMatrix();
    }

    drawn() {
      const width = this.holder.clientWidth, height = this.holder.clientHeight;
      const scale = this.camera.zoom * width / (this.camera.right - this.camera.left);  // pixels a metre
      for (const { name, at, width: room, used } of this.names) {
        const seen = at.clone().project(this.camera);
        name.style.left = (seen.x + 1) / 2 * width + 'px';
        name.style.top = (1 - seen.y) / 2 * height + 2 + 'px';
        name.style.maxWidth = room * scale + 'px';
        name.hidden = !used;
      }
    }
  }

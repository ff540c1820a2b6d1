'use strict';
// The drape in three dimensions, beside the pattern. Panels have colours; a seam can be lit.
const DrapeView = (function () {
  function panelColour(number) {
    const colour = new THREE.Color();
    colour.setHSL((number * 0.381966 + 0.57) % 1, 0.34, 0.66);
    return colour;
  }

  class DrapeView {
    // `onSeam(name)` is called when the cursor comes to a seam of the drape; null: it left.
    constructor(box, onSeam) {
      this.box = box;
      this.onSeam = onSeam;
      this.under = null;
      this.result = null;
    }

    start() {
      this.renderer = new THREE.WebGLRenderer({ antialias: true });
      this.renderer.setClearColor(0xfbfbfa);
      this.box.appendChild(this.renderer.domElement);
      this.scene = new THREE.Scene();
      this.camera = new THREE.PerspectiveCamera(24, 1, 0.01, 100);
      this.scene.add(this.camera);
      this.scene.add(new THREE.HemisphereLight(0xffffff, 0xd8d4d0, 0.62));
      const key = new THREE.DirectionalLight(0xffffff, 0.45);
      key.position.set(-0.6, 0.8, 1);
      this.camera.add(key);
      this.controls = new THREE.OrbitControls(this.camera, this.renderer.domElement);
      this.controls.addEventListener('change', () => this.render());
      window.addEventListener('resize', () => this.resize());
      this.renderer.domElement.addEventListener('pointermove', event => { if (event.buttons === 0) this.lookUnder(event); });
    }

    // `result`: points and triangles of garment and body as flat arrays, `panels` of the garment's
    // triangles, and `seams`: by name, the points along each.
    show(result) {
      this.result = result;
      try {
        if (!this.renderer) this.start();
      } catch (failed) {
        this.renderer = null;  // no WebGL: the verdict and the warnings are shown
        return;
      }
      if (this.group) this.scene.remove(this.group);
      this.group = new THREE.Group();
      this.scene.add(this.group);
      this.group.add(this.surface(result.garment, result.panels));
      if (result.body) this.group.add(this.surface(result.body, null));
      this.lit = new THREE.Group();
      this.group.add(this.lit);
      const box = new THREE.Box3().setFromObject(this.group.children[0]);
      const middle = box.getCenter(new THREE.Vector3()), size = box.getSize(new THREE.Vector3()).length();
      this.controls.target.copy(middle);
      this.camera.position.set(middle.x, middle.y, middle.z + 2.4 * size);
      this.resize();
    }

    surface(mesh, panels) {
      const shape = new THREE.BufferGeometry();
      const points = new Float32Array(9 * mesh.triangles.length / 3);
      const colours = new Float32Array(points.length);
      mesh.triangles.forEach((corner, i) => {
        for (let k = 0; k < 3; ++k) points[3 * i + k] = mesh.points[3 * corner + k];
        const colour = panels ? panelColour(panels[Math.floor(i / 3)]) : new THREE.Color(0xcfc8c2);
        colours.set([colour.r, colour.g, colour.b], 3 * i);
      });
      shape.addAttribute('position', new THREE.BufferAttribute(points, 3));
      shape.addAttribute('color', new THREE.BufferAttribute(colours, 3));
      shape.addAttribute('normal', new THREE.BufferAttribute(this.normals(mesh, points), 3));
      return new THREE.Mesh(shape, new THREE.MeshLambertMaterial(
        { vertexColors: THREE.VertexColors, side: THREE.DoubleSide }));
    }

    // Of each corner the mean of its point's triangles, by their areas.
    normals(mesh, points) {
      const sums = new Float32Array(mesh.points.length);
      for (let t = 0; t < points.length; t += 9) {
        const [a, b, c] = [0, 3, 6].map(k => new THREE.Vector3(points[t + k], points[t + k + 1], points[t + k + 2]));
        const square = b.sub(a).cross(c.sub(a));
        for (let i = 0; i < 3; ++i) {
          const corner = 3 * mesh.triangles[t / 3 + i];
          sums[corner] += square.x; sums[corner + 1] += square.y; sums[corner + 2] += square.z;
        }
      }
      const normals = new Float32Array(points.length);
      mesh.triangles.forEach((corner, i) => {
        const n = new THREE.Vector3(sums[3 * corner], sums[3 * corner + 1], sums[3 * corner + 2]).normalize();
        normals.set([n.x, n.y, n.z], 3 * i);
      });
      return normals;
    }

    // Lights the seam of that name; null: none.
    light(name) {
      if (!this.result || !this.renderer) return;
      while (this.lit.children.length > 0) this.lit.remove(this.lit.children[0]);
      const way = name === null ? null : this.result.seams[name];
      if (way) {
        const shape = new THREE.BufferGeometry();
        const points = new Float32Array(way.flatMap(p => this.pointOf(p)));
        shape.addAttribute('position', new THREE.BufferAttribute(points, 3));
        const material = new THREE.LineBasicMaterial({ color: 0xb3261e, depthTest: false });
        this.lit.add(new THREE.Line(shape, material));
      }
      this.render();
    }
    pointOf(number) { return [0, 1, 2].map(k => this.result.garment.points[3 * number + k]); }

    // The seam that is drawn nearest to the cursor, in front.
    lookUnder(event) {
      const box = this.renderer.domElement.getBoundingClientRect();
      let best = 8, depth = Infinity, under = null;  // pixels
      for (const name of Object.keys(this.result.seams)) {
        for (const number of this.result.seams[name]) {
          const p = new THREE.Vector3(...this.pointOf(number)).project(this.camera);
          const off = Math.hypot(box.left + (p.x + 1) / 2 * box.width - event.clientX,
                                 box.top + (1 - p.y) / 2 * box.height - event.clientY);
          if (off < 8 && (p.z < depth - 1e-4 || (p.z < depth + 1e-4 && off < best))) { best = off; depth = p.z; under = name; }
        }
      }
      if (under === this.under) return;
      this.under = under;
      this.light(under);
      this.onSeam(under);
    }

    resize() {
      if (!this.renderer) return;
      const width = this.box.clientWidth, height = this.box.clientHeight;
      this.renderer.setSize(width, height);
      this.camera.aspect = width / Math.max(height, 1);
      this.camera.updateProjectionMatrix();
      this.controls.update();
      this.render();
    }
    render() { this.renderer.render(this.scene, this.camera); }
  }
  return DrapeView;
})();

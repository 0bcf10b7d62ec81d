// The roadmap: guards as rings, connectors as squares, edges as the curves that they are, a little to
// the right of their middle, so that both directions are seen.

import { DoubleSide, Group, Mesh, MeshBasicMaterial, Vector3 } from 'three';
import { fan, ribbon } from './flat.js';

const kAside = 0.035;  // of an edge, to the right of its line [m]
const kNearClick = 16; // how far from an edge a click may be [CSS pixels]

function material(color) {
  return new MeshBasicMaterial({
    color, transparent: true, opacity: 0.9, side: DoubleSide, depthWrite: false,
    polygonOffset: true, polygonOffsetFactor: -3, polygonOffsetUnits: -6,
  });
}

export class Roadmap {
  constructor(page) {
    const json = page.walk.roadmap;
    this.group = new Group();
    this.json = json;
    this.isEmpty = json.nodes.length === 0;
    this.materials = { edge: material(0x6941c6), chosen: material(0xf79009), node: material(0x53389e) };
    this.edges = json.edges.map((edge) => this.addEdge({ ...edge, line: page.array(edge.line) }));
    for (const node of json.nodes) this.addNode(node);
  }

  addNode(node) {
    const mesh = new Mesh(node.connector ? fan(square(0.09)) : ring(0.08, 0.11), this.materials.node);
    mesh.position.fromArray(node.at);
    mesh.position.z += 0.012;
    mesh.rotation.z = node.heading;
    mesh.renderOrder = 5;
    this.group.add(mesh);
  }

  addEdge(edge) {
    const line = aside(edge.line);
    const group = new Group();
    const band = new Mesh(ribbon(line, 0.022, 0.01), this.materials.edge);
    const count = line.length / 3;
    const middle = 3 * Math.floor((count - 1) / 2);
    const arrow = new Mesh(fan([[-0.06, -0.05], [0.07, 0], [-0.06, 0.05]]), this.materials.edge);
    arrow.position.fromArray(line, middle);
    arrow.position.z += 0.012;
    if (count > 1) {
      const next = Math.min(middle + 3, line.length - 3), before = next - 3;
      arrow.rotation.z = Math.atan2(line[next + 1] - line[before + 1], line[next] - line[before]);
    }
    group.add(band, arrow);
    for (const mesh of group.children) mesh.renderOrder = 4;
    this.group.add(group);
    return { ...edge, line, group };
  }

  choose(index) {
    this.edges.forEach((edge, i) => {
      for (const mesh of edge.group.children) {
        mesh.material = i === index ? this.materials.chosen : this.materials.edge;
      }
    });
  }
}

/** The edge, of those with a take, that is seen at (x, y) of a canvas, or -1. */
export function edgeAt(edges, x, y, camera, canvas) {
  let found = -1, least = kNearClick;
  const p = new Vector3();
  edges.forEach((edge, index) => {
    if (edge.take === null) return;
    let before = null;
    for (let i = 0; i < edge.line.length; i += 3) {
      p.fromArray(edge.line, i).project(camera);
      const isSeen = p.z >= -1 && p.z <= 1;
      const at = isSeen ? [((p.x + 1) / 2) * canvas.clientWidth, ((1 - p.y) / 2) * canvas.clientHeight] : null;
      const away = at ? distanceTo(before ?? at, at, x, y) : Infinity;
      if (away < least) [found, least] = [index, away];
      before = at;
    }
  });
  return found;
}

// Of (x, y) to the piece between two points.
function distanceTo(a, b, x, y) {
  const [ux, uy] = [b[0] - a[0], b[1] - a[1]], long = ux * ux + uy * uy;
  const share = long > 0 ? Math.max(0, Math.min(1, ((x - a[0]) * ux + (y - a[1]) * uy) / long)) : 0;
  return Math.hypot(a[0] + share * ux - x, a[1] + share * uy - y);
}

function aside(line) {
  const count = line.length / 3;
  const moved = new Float32Array(line.length);
  for (let i = 0; i < count; ++i) {
    const a = 3 * Math.max(0, i - 1), b = 3 * Math.min(count - 1, i + 1);
    const x = line[b] - line[a], y = line[b + 1] - line[a + 1];
    const shift = kAside / (Math.hypot(x, y) || 1);
    moved[3 * i] = line[3 * i] + shift * y;
    moved[3 * i + 1] = line[3 * i + 1] - shift * x;
    moved[3 * i + 2] = line[3 * i + 2];
  }
  return moved;
}

function square(half) {
  return [[-half, -half], [half, -half], [half, half], [-half, half]];
}

function ring(inner, outer) {
  const points = [];
  for (let i = 0; i <= 40; ++i) {
    const a = (i * Math.PI) / 20;
    points.push(((inner + outer) / 2) * Math.cos(a), ((inner + outer) / 2) * Math.sin(a), 0);
  }
  return ribbon(points, outer - inner, 0);
}

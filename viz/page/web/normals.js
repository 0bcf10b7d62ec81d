// Normals of a mesh's corners: smooth where faces meet at less than the crease, sharp elsewhere.

const kCrease = Math.cos((35 * Math.PI) / 180);

// Cross products of the triangles: along their normals, twice their areas long.
function faceNormals(points, triangles) {
  const faces = new Float32Array(triangles.length);
  for (let t = 0; t < triangles.length; t += 3) {
    const a = 3 * triangles[t], b = 3 * triangles[t + 1], c = 3 * triangles[t + 2];
    const ux = points[b] - points[a], uy = points[b + 1] - points[a + 1], uz = points[b + 2] - points[a + 2];
    const vx = points[c] - points[a], vy = points[c + 1] - points[a + 1], vz = points[c + 2] - points[a + 2];
    faces[t] = uy * vz - uz * vy;
    faces[t + 1] = uz * vx - ux * vz;
    faces[t + 2] = ux * vy - uy * vx;
  }
  return faces;
}

// The triangles around each vertex, one list after another.
function facesAround(vertices, triangles) {
  const start = new Uint32Array(vertices + 1);
  for (const v of triangles) ++start[v + 1];
  for (let v = 0; v < vertices; ++v) start[v + 1] += start[v];
  const next = start.slice();
  const faces = new Uint32Array(triangles.length);
  for (let i = 0; i < triangles.length; ++i) faces[next[triangles[i]]++] = i - (i % 3);
  return { start, faces };
}

/** Three corners a triangle, one after another, with their normals. */
export function creasedNormals(points, triangles) {
  const face = faceNormals(points, triangles);
  const around = facesAround(points.length / 3, triangles);
  const positions = new Float32Array(triangles.length * 3);
  const normals = new Float32Array(triangles.length * 3);
  for (let i = 0; i < triangles.length; ++i) {
    const v = triangles[i];
    const own = i - (i % 3);
    const x = face[own], y = face[own + 1], z = face[own + 2];
    const length = Math.hypot(x, y, z);
    let nx = 0, ny = 0, nz = 0;
    for (let k = around.start[v]; k < around.start[v + 1]; ++k) {
      const f = around.faces[k];
      const fx = face[f], fy = face[f + 1], fz = face[f + 2];
      if (x * fx + y * fy + z * fz < kCrease * length * Math.hypot(fx, fy, fz)) continue;
      nx += fx;
      ny += fy;
      nz += fz;
    }
    const n = Math.hypot(nx, ny, nz) || 1;
    normals[3 * i] = nx / n;
    normals[3 * i + 1] = ny / n;
    normals[3 * i + 2] = nz / n;
    for (let k = 0; k < 3; ++k) positions[3 * i + k] = points[3 * v + k];
  }
  return { positions, normals };
}

// The packed meshes: base64 of deflated arrays; see view3d.py, which writes them.
async function unpack(text) {
  const raw = atob(text);
  const bytes = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; i++) bytes[i] = raw.charCodeAt(i);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Response(stream).arrayBuffer();
}

// Position 3 x float, normal 4 x int8, colour 4 x uint8, finish 4 x uint8, texture coordinates 2 x float.
const VERTEX_BYTES = 32;
const CREASE = Math.cos((38 * Math.PI) / 180);

// One mesh as an interleaved vertex buffer, opaque faces first: {data, opaque, count}, both in vertices.
function decodeMesh(buffer, mesh, materials) {
  const { vertices: n, faces: m, low, step } = mesh;
  const packed = new Uint16Array(buffer.slice(mesh.offset, mesh.offset + 6 * n));
  const start = mesh.offset + 6 * n;
  const wide = n > 65536;
  const order = buffer.slice(start, start + m * (wide ? 12 : 6));
  const corner = wide ? new Uint32Array(order) : new Uint16Array(order); // planar: all first corners, then all second
  const places = mesh.uv ? new Uint16Array(buffer.slice(mesh.uv.offset, mesh.uv.offset + 12 * mesh.uv.faces)) : null;
  let laid = 0; // textured faces so far
  const points = new Float32Array(3 * n);
  for (let i = 0; i < n; i++) {
    for (let k = 0; k < 3; k++) points[3 * i + k] = low[k] + packed[k * n + i] * step[k];
  }
  const normals = faceNormals(points, corner, m);
  const around = facesAround(corner, n, m);

  const data = new ArrayBuffer(3 * m * VERTEX_BYTES);
  const floats = new Float32Array(data);
  const bytes = new Uint8Array(data);
  const signed = new Int8Array(data);
  let at = 0;
  let opaque = 0;
  const runs = mesh.runs.map(([material, count], i, all) => {
    const first = all.slice(0, i).reduce((sum, run) => sum + run[1], 0);
    const from = laid;
    if (materials[material].texture > 0) laid += count;
    return { material: materials[material], first, count, from };
  });
  runs.sort((a, b) => (a.material.opacity < 1) - (b.material.opacity < 1));
  for (const { material, first, count, from } of runs) {
    if (material.opacity >= 1) opaque += 3 * count;
    for (let f = first; f < first + count; f++) {
      for (let k = 0; k < 3; k++, at++) {
        const v = corner[k * m + f];
        const normal = smooth(f, v, normals, around);
        floats.set([points[3 * v], points[3 * v + 1], points[3 * v + 2]], at * 8);
        for (let c = 0; c < 3; c++) {
          signed[at * VERTEX_BYTES + 12 + c] = Math.round(normal[c] * 127);
          bytes[at * VERTEX_BYTES + 16 + c] = Math.round(material.color[c] * 255);
        }
        bytes[at * VERTEX_BYTES + 19] = Math.round(material.opacity * 255);
        bytes[at * VERTEX_BYTES + 20] = Math.round(material.roughness * 255);
        bytes[at * VERTEX_BYTES + 21] = Math.round(material.metallic * 255);
        bytes[at * VERTEX_BYTES + 22] = Math.round(Math.min(1, material.emission) * 255);
        bytes[at * VERTEX_BYTES + 23] = material.texture;
        if (material.texture > 0) {
          const corner = 3 * (from + f - first) + k; // planar: u of all corners, then v of all
          for (let c = 0; c < 2; c++) {
            floats[at * 8 + 6 + c] = places[c * 3 * mesh.uv.faces + corner] * mesh.uv.step[c];
          }
        }
      }
    }
  }
  return { data, opaque, count: at, low: mesh.low, high: mesh.high };
}

// The images of all textures, once they can be drawn: [{color, normal}], normal null where there is none.
function loadTextures(textures) {
  const load = async (source) => {
    if (!source) return null;
    const image = new Image();
    image.src = source;
    await image.decode();
    return image;
  };
  return Promise.all(textures.map(async (t) => ({ ...t, color: await load(t.color), normal: await load(t.normal) })));
}

// Normals with the length of twice the area, so that large faces weigh more.
function faceNormals(points, corner, m) {
  const out = new Float32Array(4 * m);
  for (let f = 0; f < m; f++) {
    const [a, b, c] = [3 * corner[f], 3 * corner[m + f], 3 * corner[2 * m + f]];
    const u = [points[b] - points[a], points[b + 1] - points[a + 1], points[b + 2] - points[a + 2]];
    const v = [points[c] - points[a], points[c + 1] - points[a + 1], points[c + 2] - points[a + 2]];
    const n = cross(u, v);
    out.set([n[0], n[1], n[2], Math.hypot(n[0], n[1], n[2])], 4 * f);
  }
  return out;
}

// The faces at each vertex as a compressed table.
function facesAround(corner, n, m) {
  const start = new Uint32Array(n + 1);
  for (let i = 0; i < 3 * m; i++) start[corner[i] + 1]++;
  for (let i = 0; i < n; i++) start[i + 1] += start[i];
  const fill = start.slice(0, n);
  const face = new Uint32Array(3 * m);
  for (let i = 0; i < 3 * m; i++) face[fill[corner[i]]++] = i % m;
  return { start, face };
}

// The normal at a corner: the mean of the faces around it that bend less than a crease.
function smooth(f, v, normals, { start, face }) {
  const own = [normals[4 * f], normals[4 * f + 1], normals[4 * f + 2]];
  const length = normals[4 * f + 3] || 1;
  const sum = [0, 0, 0];
  for (let i = start[v]; i < start[v + 1]; i++) {
    const g = 4 * face[i];
    const cosine = own[0] * normals[g] + own[1] * normals[g + 1] + own[2] * normals[g + 2];
    if (cosine < CREASE * length * normals[g + 3]) continue;
    for (let c = 0; c < 3; c++) sum[c] += normals[g + c];
  }
  return unit(sum);
}

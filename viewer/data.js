// The data of the page: the JSON element "info", and the arrays that Report_arrays.h of IO/internal/report
// writes.

const array_types = { f32: Float32Array, i16: Int16Array, index: Uint32Array };

async function inflate(text) {
  const bytes = Uint8Array.from(atob(text), c => c.charCodeAt(0));
  if (typeof DecompressionStream === 'undefined')
    throw new Error('this browser is too old to unpack the data (it has no DecompressionStream)');
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

function unpack(bytes, { type, components, size, first }) {
  const Type = array_types[type],
    width = components * Type.BYTES_PER_ELEMENT;
  const out = new Uint8Array(size * width);
  for (let k = 0; k < width; ++k) {
    const plane = first + k * size;
    for (let i = 0; i < size; ++i) out[i * width + k] = bytes[plane + i];
  }
  const items = new Type(out.buffer);
  if (type === 'index')
    for (let i = 0, previous = 0; i < items.length; ++i)
      items[i] = previous += items[i] & 1 ? -(items[i] >>> 1) - 1 : items[i] >>> 1;
  return items;
}

// {info, mesh, surface, net, cad}: the last three only if there is a surface, or faces for CAD. Of a page of several parts {info, parts}: each
// part is that, or only info where it has no map. Mesh and surface are triangles that lie in one
// tile each, with these arrays; of the surface each triangle is a face:
//
//   points, charts, coordinates   per vertex: in space, and its chart point
//   normals                       per vertex, of the surface
//   shape0, shape0_normals, ...   per vertex: on the canonical surface, in each of its shapes (the mesh)
//   triangles                     three vertices each
//   faces, edges                  per triangle: the face that it is a part of, and which sides are (the mesh)
//   angle, area                   per face
//   error, mean, gauss            per vertex, if there is a surface
//   numbers, borders              of CAD: the face of each triangle; both ends of each segment of the borders
async function read_data() {
  const info = JSON.parse(document.getElementById('info').textContent);
  const bytes = await inflate(document.getElementById('arrays').textContent);
  const data = { info };
  if (info.parts) data.parts = info.parts.map(part => ({ info: part }));
  for (const [path, entry] of Object.entries(info.arrays)) {
    const [name, group, part] = path.split('.').reverse();
    const owner = part === undefined ? data : data.parts[Number(part)];
    (owner[group] = owner[group] || {})[name] = unpack(bytes, entry);
  }
  return data;
}

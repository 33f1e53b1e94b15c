// GLSL ES 3.00. All light is linear; the last step maps it to the screen.
const VERTEX = `#version 300 es
layout(location=0) in vec3 position;
layout(location=1) in vec3 normal;
layout(location=2) in vec4 color;
layout(location=3) in vec4 finish;
layout(location=4) in vec2 repeats;
uniform mat4 model, view;
uniform vec3 inverseScale; // 1 / scale^2: normals of stretched bodies
out vec3 place, facing;
out vec2 spot;
out vec4 tint;
flat out vec4 kind;
void main() {
  vec4 world = model * vec4(position, 1.0);
  place = world.xyz;
  spot = repeats;
  facing = mat3(model) * (normal * inverseScale);
  tint = color;
  kind = finish;
  gl_Position = view * world;
}`;

const DEPTH = `#version 300 es
precision highp float;
uniform float cut;
in vec3 place;
in vec4 tint;
void main() { if (place.z > cut || tint.a < 0.9) discard; }`;

const FLAT = `#version 300 es
precision highp float;
uniform float cut;
uniform vec4 flatColor;
in vec3 place;
out vec4 result;
void main() { if (place.z > cut) discard; result = flatColor; }`;

const TONE = `
// Keeps colours up to 0.8 as they are and rolls off what is brighter.
vec3 toScreen(vec3 c) {
  float low = min(c.r, min(c.g, c.b));
  c -= low < 0.08 ? low - 6.25 * low * low : 0.04;
  float peak = max(c.r, max(c.g, c.b));
  if (peak > 0.76) {
    float rolled = 1.0 - 0.0576 / (peak - 0.52);
    c *= rolled / peak;
    c = mix(vec3(rolled), c, 1.0 / (0.15 * (peak - rolled) + 1.0));
  }
  return mix(12.92 * c, 1.055 * pow(max(c, 0.0), vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));
}`;

const SURFACE = `#version 300 es
precision highp float;
precision highp sampler2DShadow;
uniform vec3 eye, sun, sky;
uniform mat4 sunView, skyView;
uniform sampler2DShadow sunMap, skyMap;
uniform float cut, texel, mapTexel, phase;
uniform int gather;    // 1: one of many frames that are added up, with light from one part of the sky
uniform float lit;     // highlight of what the pointer is on
uniform highp sampler2DArray tints, bumps;
uniform vec2 gains[64]; // of each texture: gain of its tint, 1 where it has normals
in vec3 place, facing;
in vec2 spot;
in vec4 tint;
flat in vec4 kind;
out vec4 result;
${TONE}
float hash(vec2 p) { return fract(sin(dot(p, vec2(127.1, 311.7))) * 43758.5453); }
// What shines from a direction, for reflections: floor, walls, ceiling with a bright panel.
vec3 around(vec3 d, float rough) {
  vec3 c = mix(vec3(0.42, 0.36, 0.30), vec3(0.80, 0.79, 0.77), smoothstep(-0.25 - rough, 0.15 + rough, d.z));
  float panel = smoothstep(0.80 - 0.4 * rough, 0.92 + 0.3 * rough, dot(d, normalize(vec3(sun.xy * 0.6, 1.0))));
  return c + panel * vec3(1.5, 1.45, 1.35) * (1.0 - 0.8 * rough);
}
// The frame of the texture on the surface, from how place and coordinates change over the picture.
vec3 bumped(vec3 n, vec3 map, vec3 px, vec3 py, vec2 ux, vec2 uy) {
  vec3 a = cross(py, n), b = cross(n, px);
  vec3 along = a * ux.x + b * uy.x, up = a * ux.y + b * uy.y;
  float size = max(dot(along, along), dot(up, up));
  if (size < 1e-20) return n;
  return normalize((along * map.x + up * map.y) * inversesqrt(size) + n * map.z);
}
float shadow(sampler2DShadow map, mat4 view, vec3 normal, vec3 light, float spread) {
  float slope = 1.0 - clamp(dot(normal, light), 0.0, 1.0);
  vec4 at = view * vec4(place + normal * texel * (0.6 + (0.8 + 0.6 * spread) * slope), 1.0);
  vec3 p = at.xyz * 0.5 + 0.5;
  if (any(lessThan(p, vec3(0.0))) || any(greaterThan(p, vec3(1.0)))) return 1.0;
  p.z -= 0.0006;
  float sum = 0.0, turn = hash(gl_FragCoord.xy + phase) * 6.2832;
  for (int i = 0; i < 12; i++) {
    float r = sqrt((float(i) + 0.5) / 12.0) * spread * mapTexel, a = float(i) * 2.39996 + turn;
    sum += texture(map, p + vec3(cos(a) * r, sin(a) * r, 0.0));
  }
  return sum / 12.0;
}
void main() {
  if (place.z > cut) discard;
  vec3 toEye = normalize(eye - place), n = normalize(facing);
  if (!gl_FrontFacing) {
    if (cut < 100.0) { // the section through a cut wall
      vec3 ink = vec3(0.23, 0.22, 0.21);
      result = vec4(gather == 1 ? ink : toScreen(ink), 1.0);
      return;
    }
    n = -n;
  }
  float rough = clamp(kind.x, 0.06, 1.0), metal = kind.y, glow = kind.z, pattern = floor(kind.w * 255.0 + 0.5);
  vec3 base = pow(tint.rgb, vec3(2.2)), px = dFdx(place), py = dFdy(place);
  vec2 at = vec2(spot.x, 1.0 - spot.y), ux = dFdx(spot), uy = dFdy(spot), flip = vec2(1.0, -1.0);
  if (pattern > 0.5) { // gradients by hand: neighbours may be on another surface
    int k = int(pattern) - 1;
    base *= textureGrad(tints, vec3(at, k), ux * flip, uy * flip).rgb * gains[k].x;
    vec3 map = textureGrad(bumps, vec3(at, k), ux * flip, uy * flip).xyz * 2.0 - 1.0;
    if (gains[k].y > 0.5) n = bumped(n, map, px, py, ux, uy);
  }
  float facingSun = max(dot(n, sun), 0.0);
  float sunlight = facingSun > 0.0 ? shadow(sunMap, sunView, n, sun, gather == 1 ? 2.0 : 2.6) : 0.0;
  vec3 skyColor = vec3(0.86, 0.90, 0.97), bounce = vec3(0.58, 0.54, 0.50);
  vec3 ambient;
  if (gather == 1) {
    float open = max(dot(n, sky), 0.0);
    if (open > 0.0) open *= shadow(skyMap, skyView, n, sky, 4.0);
    ambient = skyColor * 2.0 * open + bounce * (0.66 - 0.36 * n.z);
  } else {
    ambient = mix(bounce, skyColor, 0.55 + 0.45 * n.z);
  }
  vec3 sunColor = vec3(1.0, 0.93, 0.82) * 1.9;
  vec3 diffuse = base * (1.0 - metal) * (ambient * 0.86 + sunColor * facingSun * sunlight * 0.42);
  // Highlights of the sun, and what is mirrored.
  vec3 half_ = normalize(sun + toEye), f0 = mix(vec3(0.04), base, metal);
  float nv = max(dot(n, toEye), 1e-3), nh = max(dot(n, half_), 0.0), a2 = pow(rough, 4.0);
  float d = a2 / (3.1416 * pow(nh * nh * (a2 - 1.0) + 1.0, 2.0) + 1e-5);
  vec3 fresnel = f0 + (max(vec3(1.0 - rough), f0) - f0) * pow(1.0 - nv, 5.0);
  vec3 shine = fresnel * around(reflect(-toEye, n), rough) * mix(0.9, 0.35 + 0.5 * metal, rough);
  shine *= 0.35 + 0.65 * clamp(dot(ambient, vec3(0.4)), 0.0, 1.0);
  vec3 light = diffuse + shine + min(d * 0.25, 8.0) * fresnel * sunColor * facingSun * sunlight * 0.3;
  light += base * glow * 1.5;
  light = mix(light, vec3(0.25, 0.55, 1.0) * (0.3 + dot(light, vec3(0.33))), lit);
  float alpha = tint.a < 1.0 ? clamp(tint.a + (1.0 - tint.a) * pow(1.0 - nv, 4.0), 0.0, 1.0) : 1.0;
  if (gather == 0) light = toScreen(light);
  result = vec4(light * alpha, alpha);
}`;

const SCREEN = `#version 300 es
out vec2 uv;
void main() {
  uv = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0;
  gl_Position = vec4(uv * 2.0 - 1.0, 0.0, 1.0);
}`;

const SUM = `#version 300 es
precision highp float;
uniform sampler2D image, before;
in vec2 uv;
out vec4 result;
void main() { result = texture(image, uv) + texture(before, uv); }`;

const DEVELOP = `#version 300 es
precision highp float;
uniform sampler2D image;
uniform float share;
in vec2 uv;
out vec4 result;
${TONE}
void main() {
  vec4 c = texture(image, uv) * share;
  result = vec4(toScreen(c.rgb / max(c.a, 1e-4)) * c.a, c.a);
}`;

const OUTLINE = `#version 300 es
precision highp float;
uniform sampler2D image;
uniform vec2 pixel;
uniform vec4 flatColor;
in vec2 uv;
out vec4 result;
void main() {
  float here = texture(image, uv).r, most = 0.0;
  for (int i = 0; i < 16; i++) {
    float a = float(i) * 0.3927;
    most = max(most, texture(image, uv + vec2(cos(a), sin(a)) * pixel).r);
  }
  float edge = clamp(most - here, 0.0, 1.0);
  result = vec4(flatColor.rgb, 1.0) * (edge * flatColor.a + here * 0.10);
}`;

const LINES = `#version 300 es
layout(location=0) in vec3 position;
uniform mat4 model, view;
uniform vec3 low, high;
out vec3 place;
void main() {
  vec4 world = model * vec4(mix(low, high, position), 1.0);
  place = world.xyz;
  gl_Position = view * world;
  gl_Position.z -= 0.0005 * gl_Position.w;
}`;

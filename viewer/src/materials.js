// How surfaces and balls look: lit from over the viewer's shoulder, edges denser than faces, as in glass.
import { DoubleSide, ShaderMaterial } from 'three';

const vertexShader = /* glsl */ `
  attribute vec3 tint;
  attribute float part;
  varying vec3 vNormal, vPosition, vTint;
  varying float vPart;
  void main() {
    vec4 p = modelViewMatrix * vec4(position, 1.0);
    vPosition = p.xyz;
    vNormal = normalMatrix * normal;
    vTint = tint;
    vPart = part;
    gl_Position = projectionMatrix * p;
  }`;

const ballVertexShader = /* glsl */ `
  varying vec3 vNormal, vPosition, vTint;
  void main() {
    vec4 p = modelViewMatrix * instanceMatrix * vec4(position, 1.0);
    vPosition = p.xyz;
    vNormal = normalMatrix * normal;
    vTint = instanceColor;
    gl_Position = projectionMatrix * p;
  }`;

const lighting = /* glsl */ `
  varying vec3 vNormal, vPosition, vTint;
  vec3 lit(vec3 colour, vec3 n, vec3 eye, float shine) {
    vec3 light = normalize(vec3(0.35, 0.75, 0.6));
    float diffuse = 0.72 + 0.28 * dot(n, light);
    float spark = pow(max(0.0, dot(n, normalize(light + eye))), 50.0);
    return colour * diffuse + shine * spark;
  }`;

// Where the smooth normal is far from the triangle's own, there is a crease: then the triangle's own is used.
const surfaceShader = /* glsl */ `
  ${lighting}
  varying float vPart;
  uniform float opacity;
  void main() {
    vec3 eye = normalize(-vPosition);
    vec3 flatNormal = normalize(cross(dFdx(vPosition), dFdy(vPosition)));
    vec3 n = normalize(vNormal);
    n = abs(dot(n, flatNormal)) > 0.8 ? n : flatNormal;
    n = faceforward(n, -eye, n);
    float rim = pow(1.0 - max(0.0, dot(n, eye)), 2.2);
    float alpha = opacity * (0.8 + 0.2 * vPart);
    alpha = clamp(alpha + (1.0 - alpha) * rim * 0.75, 0.0, 1.0);
    gl_FragColor = vec4(lit(vTint, n, eye, 0.25) * (1.0 - 0.3 * rim), alpha);
  }`;

const ballShader = /* glsl */ `
  ${lighting}
  uniform float glass;
  void main() {
    vec3 eye = normalize(-vPosition);
    vec3 n = normalize(vNormal);
    float rim = pow(1.0 - max(0.0, dot(n, eye)), 2.0);
    gl_FragColor = vec4(lit(vTint, n, eye, 0.35), mix(1.0, 0.1 + 0.55 * rim, glass));
  }`;

export function surfaceMaterial() {
  return new ShaderMaterial({
    vertexShader, fragmentShader: surfaceShader, uniforms: { opacity: { value: 1 } },
    transparent: true, depthWrite: false, side: DoubleSide,
  });
}

/// Matched balls are solid, the others glass.
export function ballMaterial(glass) {
  return new ShaderMaterial({
    vertexShader: ballVertexShader, fragmentShader: ballShader, uniforms: { glass: { value: glass ? 1 : 0 } },
    transparent: glass, depthWrite: !glass,
  });
}

// Translucent surfaces, drawn exactly from back to front at every pixel, also where they cross.

/** The piece with every triangle turned so that its corners go round the normal at the first one counterclockwise. */
function oriented(piece) {
  const {positions, normals, triangles} = piece;
  const corner = (list, i) => list.slice(3 * i, 3 * i + 3);
  for (let t = 0; t < triangles.length; t += 3) {
    const [p, q, r] = [0, 1, 2].map((k) => corner(positions, triangles[t + k]));
    if (dot(cross(minus(q, p), minus(r, p)), corner(normals, triangles[t])) < 0) [triangles[t + 1], triangles[t + 2]] = [triangles[t + 2], triangles[t + 1]];
  }
  return piece;
}

/** Triangles of a grid of points with normals, for the translucent surfaces. */
function gridPiece(rows, columns, pointAt, property, opacity) {
  const piece = {positions: [], normals: [], triangles: [], property, opacity};
  for (let i = 0; i <= rows; ++i)
    for (let j = 0; j <= columns; ++j) {
      const {at, normal} = pointAt(i / rows, j / columns);
      piece.positions.push(...at);
      piece.normals.push(...normal);
    }
  for (let i = 0; i < rows; ++i)
    for (let j = 0; j < columns; ++j) {
      const a = i * (columns + 1) + j;
      const b = a + columns + 1;
      piece.triangles.push(a, b, a + 1, b, b + 1, a + 1);
    }
  return oriented(piece);
}

const mostLayers = 24;

/** A fragment keeps its depth, a little behind so that lines on a surface are seen, if it is in front of the layer before. */
const peelingMain = `uniform highp sampler2D before;
uniform bool peeling;
void main() {
  float shown = gl_FragCoord.z + fwidth(gl_FragCoord.z) + 2.0e-6;
  if (peeling && shown >= texelFetch(before, ivec2(gl_FragCoord.xy), 0).r) discard;
  gl_FragDepth = shown;`;

const plainVertex = 'void main() { gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }';
const countFragment = 'void main() { gl_FragColor = vec4(1.0 / 255.0); }';
const wholeVertex = 'void main() { gl_Position = vec4(position, 1.0); }';
/** The mean of the layer's samples in a pixel, at the depth of the nearest of them. */
const layerFragment = `uniform sampler2D colours;
uniform highp sampler2D depths;
uniform int samples;
void main() {
  vec4 sum = vec4(0.0);
  float nearest = 1.0;
  for (int i = 0; i < samples; ++i)
    for (int j = 0; j < samples; ++j) {
      ivec2 at = ivec2(gl_FragCoord.xy) * samples + ivec2(i, j);
      vec4 colour = texelFetch(colours, at, 0);
      sum += vec4(colour.rgb * colour.a, colour.a);
      if (colour.a > 0.0) nearest = min(nearest, texelFetch(depths, at, 0).r);
    }
  if (sum.a == 0.0) discard;
  gl_FragDepth = nearest;
  gl_FragColor = vec4(sum.rgb / sum.a, sum.a / float(samples * samples));
  #include <colorspace_fragment>
}`;

/**
 * All translucent triangles in one mesh. They are peeled off layer by layer (Everitt 2001), from the farthest to the
 * nearest, each laid over what is drawn already; what is opaque hides them by its depth.
 */
class Translucent {
  constructor() {
    this.geometry = new THREE.BufferGeometry();
    this.before = {value: null};
    this.peeling = {value: false};
    this.material = new THREE.MeshPhongMaterial({vertexColors: true, side: THREE.DoubleSide, depthFunc: THREE.GreaterDepth, shininess: 18, specular: 0x202020});
    this.material.transparent = true;
    this.material.blending = THREE.CustomBlending;  // a fragment replaces what is behind it in its layer
    Object.assign(this.material, {blendEquation: THREE.AddEquation, blendSrc: THREE.OneFactor, blendDst: THREE.ZeroFactor, forceSinglePass: true, depthWrite: true});
    this.material.onBeforeCompile = (shader) => {
      Object.assign(shader.uniforms, {before: this.before, peeling: this.peeling});
      shader.fragmentShader = shader.fragmentShader.replace('void main() {', peelingMain);
    };
    this.counter = new THREE.ShaderMaterial({vertexShader: plainVertex, fragmentShader: countFragment, side: THREE.DoubleSide, transparent: true, depthTest: false,
      depthWrite: false, blending: THREE.CustomBlending, blendEquation: THREE.AddEquation, blendSrc: THREE.OneFactor, blendDst: THREE.OneFactor});
    this.mesh = new THREE.Mesh(this.geometry, this.material);
    this.mesh.frustumCulled = false;
    this.headlight = new THREE.DirectionalLight(0xffffff, 2.1);
    this.scene = new THREE.Scene();
    this.scene.add(new THREE.AmbientLight(0xffffff, 1.35), this.headlight, this.mesh);
    this.counts = new THREE.WebGLRenderTarget(192, 144, {depthBuffer: false, minFilter: THREE.NearestFilter, magFilter: THREE.NearestFilter});
    this.layers = [];
    this.laid = new THREE.ShaderMaterial({vertexShader: wholeVertex, fragmentShader: layerFragment, transparent: true, depthWrite: false,
      uniforms: {colours: {value: null}, depths: {value: null}, samples: {value: 1}}});
    const whole = new THREE.BufferGeometry();
    whole.setAttribute('position', new THREE.BufferAttribute(new Float32Array([-1, -1, 0, 3, -1, 0, -1, 3, 0]), 3));
    const sheet = new THREE.Mesh(whole, this.laid);
    sheet.frustumCulled = false;
    this.sheets = new THREE.Scene();
    this.sheets.add(sheet);
    this.flat = new THREE.OrthographicCamera(-1, 1, 1, -1, 0, 1);
  }

  show(pieces) {
    const count = pieces.reduce((n, piece) => n + piece.positions.length / 3, 0);
    const positions = new Float32Array(3 * count);
    const normals = new Float32Array(3 * count);
    const colours = new Float32Array(4 * count);
    const triangles = [];
    let offset = 0;
    for (const piece of pieces) {
      positions.set(piece.positions, 3 * offset);
      normals.set(piece.normals, 3 * offset);
      const tint = new THREE.Color(colour(piece.property));
      const size = piece.positions.length / 3;
      for (let i = 0; i < size; ++i) colours.set([tint.r, tint.g, tint.b, piece.opacity], 4 * (offset + i));
      for (const corner of piece.triangles) triangles.push(corner + offset);
      offset += size;
    }
    this.geometry.dispose();
    this.geometry.setAttribute('position', new THREE.BufferAttribute(positions, 3));
    this.geometry.setAttribute('normal', new THREE.BufferAttribute(normals, 3));
    this.geometry.setAttribute('color', new THREE.BufferAttribute(colours, 4));
    this.geometry.setIndex(new THREE.BufferAttribute(Uint32Array.from(triangles), 1));
  }

  /** How many triangles lie behind each other at most. */
  depthOfLayers(renderer, camera) {
    this.mesh.material = this.counter;
    renderer.setRenderTarget(this.counts);
    renderer.clear();
    renderer.render(this.scene, camera);
    this.mesh.material = this.material;
    const {width, height} = this.counts;
    const pixels = new Uint8Array(4 * width * height);
    renderer.readRenderTargetPixels(this.counts, 0, 0, width, height, pixels);
    let most = 0;
    for (let i = 0; i < pixels.length; i += 4) most = Math.max(most, pixels[i]);
    return Math.min(most, mostLayers);
  }

  resize(width, height) {
    if (this.layers.length && this.layers[0].width === width && this.layers[0].height === height) return;
    for (const layer of this.layers) layer.dispose();
    this.layers = [0, 1].map(() => {
      const layer = new THREE.WebGLRenderTarget(width, height, {colorSpace: THREE.SRGBColorSpace, minFilter: THREE.NearestFilter, magFilter: THREE.NearestFilter});
      layer.depthTexture = new THREE.DepthTexture(width, height, THREE.FloatType);
      return layer;
    });
  }

  /** Lays every layer over the canvas, whose opaque things are drawn already. */
  draw(renderer, camera) {
    if (!this.geometry.index || this.geometry.index.count === 0) return;
    this.headlight.position.copy(camera.position).add(new THREE.Vector3(0.6, 0.2, 1.2));
    const size = renderer.getDrawingBufferSize(new THREE.Vector2());
    const samples = renderer.getPixelRatio() < 1.5 ? 2 : 1;
    this.resize(size.x * samples, size.y * samples);
    renderer.setClearColor(0x000000, 0);
    const layers = this.depthOfLayers(renderer, camera);
    const depth = renderer.state.buffers.depth;
    for (let k = 0; k < layers; ++k) {
      const layer = this.layers[k % 2];
      this.before.value = this.layers[(k + 1) % 2].depthTexture;
      this.peeling.value = k > 0;
      renderer.setRenderTarget(layer);
      depth.setClear(0);
      renderer.clear();
      depth.setClear(1);
      renderer.render(this.scene, camera);
      renderer.setRenderTarget(null);
      Object.assign(this.laid.uniforms, {colours: {value: layer.texture}, depths: {value: layer.depthTexture}, samples: {value: samples}});
      renderer.render(this.sheets, this.flat);
    }
    renderer.setRenderTarget(null);
  }
}

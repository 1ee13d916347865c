#!/usr/bin/env bash
# Makes three.js, the part of three.js (https://threejs.org, MIT) that the report page uses, from its npm package. Needs
# node and npm; building exsect needs neither, since the result is kept in the tree. Run it to take a newer version.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
echo '{"private": true}' >package.json
version=0.187.0
npm install --silent --no-audit --no-fund "three@$version" esbuild@0.28.2
cat >three-parts.js <<'PARTS'
export { AmbientLight, BufferAttribute, BufferGeometry, Color, CustomBlending, AddEquation, DepthTexture, DirectionalLight,
         DoubleSide, FloatType, GreaterDepth, Group, Mesh, MeshPhongMaterial, NearestFilter, OneFactor, OrthographicCamera,
         PerspectiveCamera, Scene, ShaderMaterial, Spherical, SRGBColorSpace, Vector2, Vector3, WebGLRenderer,
         WebGLRenderTarget, ZeroFactor } from 'three';
export { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
export { LineMaterial } from 'three/examples/jsm/lines/LineMaterial.js';
export { LineSegments2 } from 'three/examples/jsm/lines/LineSegments2.js';
export { LineSegmentsGeometry } from 'three/examples/jsm/lines/LineSegmentsGeometry.js';
PARTS
npx --no-install esbuild three-parts.js --bundle --minify --format=iife --global-name=THREE --target=es2020 \
  --charset=utf8 --legal-comments=none --log-level=warning --outfile=bundled.js
{
  echo "/* three.js $version, part of it, minified by output/report/bundle.sh."
  sed -e 's/^/ * /' -e 's/ *$//' node_modules/three/LICENSE
  echo " */"
  cat bundled.js
} >"$here/three.js"
echo "three.js: $(wc -c <"$here/three.js") bytes"

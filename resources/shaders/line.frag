// Coverage from the distance to the segment. Where a neighbour is nearer, the neighbour draws the pixel: so
// joins are round and translucent lines do not blend twice. Ties go to the earlier segment; both
// evaluate the same expressions at the same pixel centre and so agree.
#version 330 core
flat in vec4 ends, outer, fromColour, toColour;
flat in float lineWidth;
in vec2 place;
out vec4 fragment;
uniform vec2 pictureSize;

float placeAlong(vec2 p, vec2 a, vec2 b) {
  vec2 ab = b - a;
  float square = dot(ab, ab);
  return square > 0.0 ? clamp(dot(p - a, ab) / square, 0.0, 1.0) : 0.0;
}
float distanceTo(vec2 p, vec2 a, vec2 b) { return distance(p, mix(a, b, placeAlong(p, a, b))); }

void main() {
  vec2 p = vec2(gl_FragCoord.x, pictureSize.y - gl_FragCoord.y);
  float here = distanceTo(p, ends.xy, ends.zw);
  if (outer.xy != ends.xy && distanceTo(p, outer.xy, ends.xy) <= here) discard;
  if (outer.zw != ends.zw && distanceTo(p, ends.zw, outer.zw) < here) discard;
  float coverage = clamp(0.5 * max(lineWidth, 1.0) + 0.5 - here, 0.0, 1.0) * min(lineWidth, 1.0);
  if (coverage <= 0.0) discard;
  fragment = mix(fromColour, toColour, placeAlong(p, ends.xy, ends.zw));
  fragment.a *= coverage;
}

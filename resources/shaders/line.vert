// One segment of a polyline as a quad, wide enough for its width, its round ends and the smooth edge. One
// instance a segment, four corners by gl_VertexID.
#version 330 core
layout(location = 0) in vec4 segment;     // its two ends
layout(location = 1) in vec4 neighbours;  // the end before, the end after
layout(location = 2) in vec4 colourFrom;
layout(location = 3) in vec4 colourTo;
layout(location = 4) in float width;
uniform vec2 pictureSize;
flat out vec4 ends, outer, fromColour, toColour;
flat out float lineWidth;
out vec2 place;
void main() {
  ends = segment;
  outer = neighbours;
  fromColour = colourFrom;
  toColour = colourTo;
  lineWidth = width;
  vec2 along = segment.zw - segment.xy;
  float size = length(along);
  along = size > 0.0 ? along / size : vec2(1, 0);
  vec2 across = vec2(-along.y, along.x);
  float reach = 0.5 * max(width, 1.0) + 1.0;
  vec2 end = (gl_VertexID & 1) == 0 ? segment.xy - along * reach : segment.zw + along * reach;
  place = end + across * ((gl_VertexID & 2) == 0 ? -reach : reach);
  gl_Position = vec4(place / pictureSize * vec2(2, -2) + vec2(-1, 1), 0, 1);
}

// A filled triangle's corner: pixels (origin top left, y down) to clip space.
#version 330 core
layout(location = 0) in vec2 position;
layout(location = 1) in vec4 colour;
uniform vec2 pictureSize;
out vec4 fill;
void main() {
  fill = colour;
  gl_Position = vec4(position / pictureSize * vec2(2, -2) + vec2(-1, 1), 0, 1);
}

#version 330 core
in vec4 fill;
out vec4 fragment;
void main() { fragment = fill; }

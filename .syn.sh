# Qt syntax check of one file
f=$1
I="-I/work/map -isystem /usr/include/x86_64-linux-gnu/qt6 -isystem /usr/lib/x86_64-linux-gnu/qt6/mkspecs/linux-g++"
for m in Core Gui Widgets Charts OpenGL OpenGLWidgets; do I="$I -isystem /usr/include/x86_64-linux-gnu/qt6/Qt$m"; done
g++ -std=c++20 -fsyntax-only -fPIC -DFMT_SHARED -DASPERITY_VERSION=\"x\" -Wall -Wextra -Wshadow -Wconversion -Wno-sign-conversion $I $f

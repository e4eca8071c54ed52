// What every pass of a frame knows: std140, read by C++ and GLSL both. Only 16-byte members, so that both lay it out alike.

struct FrameUniforms {
    mat4 clipFromWorld;
    vec4 eye;  // w: distance of the near plane
    // Perspective: world direction, one metre deep, through the centre of pixel (0, 0). Orthographic: the way from the eye to that pixel.
    vec4 rayCorner;
    vec4 rayStepX;       // added for each pixel to the right; w: as CameraView::shift in x, of the frame
    vec4 rayStepY;       // added for each pixel up; w: the same in y
    vec4 cameraRight;    // w: half the frame's width, in a perspective view one metre deep
    vec4 cameraUp;       // w: half its height
    vec4 cameraForward;  // w: 1 with specular antialiasing, else 0
    // Perspective: near / far plane, 1 - near / far plane, 0, 0. Orthographic: 0, far plane, far - near plane, 1.
    vec4 depthRange;
    vec4 workingFromRed;  // columns of the matrix from linear Rec.709 to the working space
    vec4 workingFromGreen;
    vec4 workingFromBlue;
    // Rows of the rotation from the world to the frame of the environment's picture; w of the first: its intensity.
    vec4 environmentX;
    vec4 environmentY;
    vec4 environmentZ;
    vec4 elementSizes;  // size of points, width of lines, pixels
    ivec4 size;         // width, height; z, w: of the picture's pixels, the one at the frame's lower left corner
    ivec4 lightCounts;  // points, spots, directional lights; w: width of the picture, of which the frame may be a part
};

// Empty: marking a volume writes only the stencil.

void main() {}
